using System;
using System.Threading;

/// <summary>Answers each number by what two threads compute; a timer fires all the time.</summary>
static class Threads
{
    static int ticks;

    static long Work(long seed)
    {
        long value = seed;
        for (int k = 0; k < 20000; k++)
        {
            value = (value * 1103515245 + 12345) % (1L << 31);
        }
        return value;
    }

    static void Main()
    {
        using (new Timer(state => Interlocked.Increment(ref ticks), null, 3, 3))
        {
            string line;
            while ((line = Console.ReadLine()) != null)
            {
                long number = long.Parse(line);
                long[] found = new long[2];
                Thread[] threads = new Thread[2];
                for (int k = 0; k < 2; k++)
                {
                    int place = k;
                    threads[k] = new Thread(() => found[place] = Work(number + place));
                    threads[k].Start();
                }
                foreach (Thread thread in threads)
                {
                    thread.Join();
                }
                Console.WriteLine(found[0] + found[1]);
            }
        }
    }
}
