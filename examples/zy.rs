use signorini::sobolev::*; use signorini::*;
fn main(){
   let f=SingularFunction::new(&[0.0,1.0],|x:f64|x.powf(-0.249)).unwrap();
   println!("{:?}",f.seminorm("0.25".parse().unwrap(),Tolerance::new(1e-3).unwrap()));
   let f=SingularFunction::new(&[0.0,1.0],|x:f64|x.powf(0.6)).unwrap();
   println!("{:?}",f.seminorm("0.99".parse().unwrap(),Tolerance::new(1e-11).unwrap()));
   let f=SingularFunction::new(&[0.0,1.0],|x:f64|x).unwrap();
   println!("{:?}",f.seminorm("0.999".parse().unwrap(),Tolerance::new(1e-11).unwrap()));
   let al=0.4; 
   let f=SingularFunction::from_positions(&[0.0,1.0],|p:Position| if p.anchor()==0 {(-p.offset().ln()).powf(al)} else {(-(p.offset().ln_1p())).powf(al)}).unwrap();
   println!("{:?}",f.seminorm(FractionalOrder::HALF,Tolerance::new(1e-11).unwrap()));
}
