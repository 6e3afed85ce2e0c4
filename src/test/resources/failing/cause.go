// says: panic: inner
package main
import ("fmt";"errors")
func main(){ defer func(){ r:=recover(); panic(fmt.Errorf("outer: %v", r)) }(); panic(errors.New("inner\nsecond")) }
