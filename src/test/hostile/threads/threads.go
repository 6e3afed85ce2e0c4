// Answers each number by what goroutines compute; a ticker goes all the time, and a signal is caught.
package main

import (
	"bufio"
	"fmt"
	"os"
	"os/signal"
	"runtime"
	"strconv"
	"sync"
	"syscall"
	"time"
)

func main() {
	caught := make(chan os.Signal, 1)
	signal.Notify(caught, syscall.SIGCONT)
	ticks := 0
	go func() {
		for range time.NewTicker(3 * time.Millisecond).C {
			ticks++
		}
	}()
	lines := bufio.NewScanner(os.Stdin)
	for lines.Scan() {
		seed, _ := strconv.Atoi(lines.Text())
		found := make([]int, 4)
		var all sync.WaitGroup
		for k := range found {
			all.Add(1)
			go func(k int) {
				defer all.Done()
				value := seed + k
				for step := 0; step < 100000; step++ {
					value = (value*1103515245 + 12345) % (1 << 31)
				}
				found[k] = value
			}(k)
		}
		all.Wait()
		runtime.GC()
		fmt.Println(found[0] + found[1] + found[2] + found[3])
	}
}
