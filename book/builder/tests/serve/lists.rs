//! Words of hostile requests, divided by blanks; PORT stands for that of the server, `␣` for a blank, `∅` for nothing.

/// The words of a list.
pub fn words(list: &str) -> Vec<String> {
    list.split(' ').map(|word| word.replace('∅', "").replace('␣', " ")).collect()
}

pub const HOSTS: &str = "evil.example evil.example:80 127.0.0.1 127.0.0.1:1 localhost localhost.evil.example:PORT \
    127.0.0.1.evil.example:PORT 127.0.0.1:PORT.evil.example [::1]:PORT 0.0.0.0:PORT \
    2130706433:PORT 127.1:PORT LOCALHOST:PORT user@127.0.0.1:PORT 127.0.0.1:PORT/ \
    127.0.0.1:0PORT ∅ *";

pub const ORIGINS: &str = "null http://evil.example https://127.0.0.1:PORT http://127.0.0.1 http://127.0.0.1:1 \
    http://127.0.0.1:PORT.evil.example http://127.0.0.1:PORT@evil.example \
    http://evil.example/127.0.0.1:PORT http://localhost:PORT file:// http://[::1]:PORT \
    http://127.0.0.1:PORT/ HTTP://127.0.0.1:PORT http://127.0.0.1:PORT,␣http://evil.example ∅ \
    127.0.0.1:PORT";

pub const PATHS: &str = "/../secret.txt /../../secret.txt /..%2fsecret.txt /%2e%2e/secret.txt /%2e%2e%2fsecret.txt \
    /..%5csecret.txt /..\\secret.txt /....//secret.txt /./../secret.txt \
    /first.html/../../secret.txt //secret.txt ///etc/passwd /etc/passwd /%2fetc%2fpasswd \
    /secret.txt /first.html%00.txt /first.html/ /first.html. /FIRST.HTML /first /book.toml \
    /../book.toml /src/first.md /../src/first.md /../generated/values.json /.git/config \
    /../../.git/config /planted /planted.log /../../planted.log /css/../../src/first.md \
    /%c0%ae%c0%ae/secret.txt /%252e%252e/secret.txt /..;/secret.txt /~root/.ssh/id_rsa \
    /proc/self/environ /C:/Windows/win.ini /file:///etc/passwd /run /index.html;x";

pub const METHODS: &str = "PUT DELETE PATCH OPTIONS TRACE PROPFIND MKCOL MOVE LINK PURGE post RUN";

pub const EXAMPLES: &str = "none ∅ ../planted ./planted /bin/ls ls planted;ls planted␣ PLANTED planted.rs \
    planted/../planted planted\u{0}";

pub const PAGES: &str = "none.html ../first.html /first.html first.md ∅ first.html#x";

pub const NAMES: &str = "out values json describe help version --x -x x=1 X x␣ ∅ ../x mode\u{0}";

/// Values that an option does not take.
pub const VALUES: [(&str, &str); 8] = [
    (
        "x",
        "NaN nan inf -inf infinity 1e999 -1e999 2 -1 0x10 1_0 0.5f 1,2 ½ 0.5;ls $(ls) `ls` |ls \
    &ls >x <x ' \" \\ * ? ~ ${HOME} %s%n --out=/tmp -o ../secret.txt /etc/passwd 0.5\n0.6 \
    0.5\u{0} \r\nX:␣y 0..5 e .",
    ),
    ("nu", "0.5, , 0.5,,0.6 1/3 1/2+/etc 2 0.5,nan 1/2-inf a"),
    ("n", "-1 0 65 1e1 8.0 99999999999999999999 0x8 8,8 8␣8"),
    ("tolerance", "slow fast;ls nan balanced,fast"),
    ("levels", "3 9-3 3-99 -3-9 3-9-12 a-b 3-4294967296 ../3-9"),
    (
        "scene",
        "samples:/etc/passwd block:/etc/passwd cantor:x cantor:0.3:$(ls) strip ../block \
    cantor:nan block:\u{0}",
    ),
    ("lines", "yes 1 true;ls --out"),
    ("mode", "sleep answer␣wait wait\nx ANSWER --mode=wait"),
];

pub const TYPES: &str =
    "text/plain application/x-www-form-urlencoded multipart/form-data application/json;␣x ∅";

/// Between bars, `~` for a quotation mark.
pub const BODIES: &str = "|{|}|[]|null|1|~x~|{}|{~example~:~planted~}|{'example':'planted'}|\
    {~example~:~planted~,~page~:~first.html~}|{~example~:~planted~,~page~:~first.html~,~options~:[]}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{~x~:0.4}}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{~x~:[~0.4~]}}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{~x~:null}}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{},~shell~:~ls~}|\
    {~example~:[~planted~],~page~:~first.html~,~options~:{}}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{}} {}|\
    {~example~:~planted~,~page~:~first.html~,~options~:{}|example=planted&page=first.html";
