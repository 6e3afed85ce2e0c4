// says: fatal error: all goroutines are asleep - deadlock!
package main
func main(){ c:=make(chan int); <-c }
