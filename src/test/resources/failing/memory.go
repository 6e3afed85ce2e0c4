// says: fatal error: out of memory
package main
func main(){ n:=1<<47; _ = make([]byte, n) [3] }
