// says: syntax.go:3:30: undefined: y
package main
func main(){ x := 1; _ = x + y; _ = z }
