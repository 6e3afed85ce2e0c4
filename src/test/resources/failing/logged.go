// says: no turn read
package main
import "log"
func main(){ log.Fatal("no turn read") }
