// says: panic: runtime error: index out of range [5] with length 0
package main
func main(){ var a []int; i:=5; _ = a[i] }
