//! `cargo book serve`: the book on a loopback address, where a page may compute with other parameters.
//!
//! Only this machine is answered: the socket is bound to 127.0.0.1, `Host` must name it, and a request to
//! compute must come from a page of this server (`Origin`). Files are looked up by their whole name among
//! those of the built book; no request names a path. Only known examples run, with declared options
//! ([`crate::options`]), one at a time, without a shell, within [`Limits`]; when the page that asked goes
//! away, its connection closes and the run is killed.

mod answer;
mod laboratory;
mod limits;
mod render;
mod run;

pub use laboratory::Laboratory;
pub use limits::Limits;

use crate::error::{Error, Result};
use answer::answer;
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use std::net::{Ipv4Addr, SocketAddr};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Runtime};
use tokio::sync::Semaphore;
use tokio::task::LocalSet;

/// Bytes of a request's head, and how many fields it may have.
const HEAD: usize = 16 << 10;
const FIELDS: usize = 64;

/// A server that is bound and not yet running.
pub struct Server {
    runtime: Runtime,
    listener: TcpListener,
    address: SocketAddr,
    laboratory: Laboratory,
}

impl Server {
    /// Binds to 127.0.0.1; port 0 takes a free one.
    ///
    /// # Errors
    /// [`Error::Server`] when the port is taken.
    pub fn bind(laboratory: Laboratory, port: u16) -> Result<Self> {
        let failed = |source| Error::Server { port, source };
        let runtime = Builder::new_current_thread().enable_all().build().map_err(failed)?;
        let listener =
            runtime.block_on(TcpListener::bind((Ipv4Addr::LOCALHOST, port))).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        Ok(Self { runtime, listener, address, laboratory })
    }

    /// The address it is bound to.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Answers until the process ends.
    ///
    /// # Errors
    /// None so far.
    pub fn run(self) -> Result<()> {
        let Self { runtime, listener, address, laboratory } = self;
        LocalSet::new().block_on(&runtime, accept(listener, address, Rc::new(laboratory)));
        Ok(())
    }
}

/// One task per connection, as many as [`Limits::connections`].
async fn accept(listener: TcpListener, address: SocketAddr, laboratory: Rc<Laboratory>) {
    let limits = *laboratory.limits();
    let open = Arc::new(Semaphore::new(limits.connections));
    loop {
        let Ok(place) = Arc::clone(&open).acquire_owned().await else { return };
        let Ok((stream, _)) = listener.accept().await else {
            tokio::time::sleep(Duration::from_millis(10)).await;
            continue;
        };
        let laboratory = Rc::clone(&laboratory);
        tokio::task::spawn_local(async move {
            let service = service_fn(|request| answer(request, address, &laboratory));
            let mut http = http1::Builder::new();
            http.timer(TokioTimer::new()).header_read_timeout(limits.request).max_headers(FIELDS);
            http.max_buf_size(HEAD).half_close(false);
            // What ends a connection early is the other side's affair.
            let _ = http.serve_connection(TokioIo::new(stream), service).await;
            drop(place);
        });
    }
}
