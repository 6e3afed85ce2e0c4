// says: in thread
fn main(){ std::thread::spawn(||{ panic!("in thread\nsecond") }).join().unwrap(); }
