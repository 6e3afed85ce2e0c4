package steward.replay;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import steward.numerics.SplitMix64;

/** Bytes handed to the writing thread come to the file whole, in order and soon; and so do its problems. */
class WriteBehindTest {

    /** A file that tells when something has come. */
    private static class Sink extends OutputStream {

        final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        final CountDownLatch came = new CountDownLatch(1);
        boolean closed;

        @Override
        public void write(int one) {
            throw new AssertionError("one by one");
        }

        @Override
        public synchronized void write(byte[] source, int from, int count) throws IOException {
            bytes.write(source, from, count);
            came.countDown();
        }

        @Override
        public void close() {
            closed = true;
        }
    }

    @Test
    void everythingInOrder() throws IOException {
        SplitMix64 random = new SplitMix64(8);
        Sink sink = new Sink();
        ByteArrayOutputStream expected = new ByteArrayOutputStream();
        try (WriteBehind out = new WriteBehind(sink)) {
            for (int k = 0; k < 3000; k++) {
                byte[] line = new byte[k % 500 == 7 ? 200_000 : random.nextInt(1, 3000)];
                java.util.Arrays.fill(line, (byte) k);
                out.write(line, 0, line.length);
                expected.write(line, 0, line.length);
                if (k % 700 == 0) {
                    out.flush();
                    assertEquals(expected.size(), sink.bytes.size(), "after a flush");
                }
            }
        }

        assertArrayEquals(expected.toByteArray(), sink.bytes.toByteArray());
        assertTrue(sink.closed);
    }

    /** A line is not held back until there are more: it is in the file even if this JVM is killed. */
    @Test
    void aSingleLineComesByItself() throws IOException, InterruptedException {
        for (int repetition = 0; repetition < 3; repetition++) {
            Sink sink = new Sink();
            try (WriteBehind out = new WriteBehind(sink)) {
                out.write(new byte[] {1, 2, 3}, 0, 3);

                assertTrue(sink.came.await(10, TimeUnit.SECONDS));
            }
        }
    }

    @Test
    void aFullDiskIsTold() {
        OutputStream full = new OutputStream() {
            @Override
            public void write(int one) throws IOException {
                throw new IOException("No space left on device");
            }
        };
        WriteBehind out = new WriteBehind(full);

        IOException told = assertThrows(IOException.class, () -> {
            out.write(new byte[] {1}, 0, 1);
            out.flush();
        });
        assertEquals("No space left on device", told.getMessage());
        assertThrows(IOException.class, () -> out.write(new byte[] {1}, 0, 1), "from then on always");
        assertThrows(IOException.class, out::close);
    }

    @Test
    void whateverGoesWrongWithAFileIsTold() {
        WriteBehind out = new WriteBehind(new OutputStream() {
            @Override
            public void write(int one) {
                throw new IllegalStateException("no such luck");
            }
        });

        IOException told = assertThrows(IOException.class, () -> {
            out.write(new byte[] {1}, 0, 1);
            out.flush();
        });
        assertEquals("java.lang.IllegalStateException: no such luck", told.getMessage());
    }

    /** A stream whose buffer is full is written by its own thread, and does not wait for the file of another stream. */
    @Test
    void aStuckFileHoldsUpNobodyElse() throws IOException, InterruptedException {
        CountDownLatch letGo = new CountDownLatch(1);
        CountDownLatch stuck = new CountDownLatch(1);
        OutputStream slow = new Sink() {
            @Override
            public void write(byte[] source, int from, int count) throws IOException {
                stuck.countDown();
                try {
                    letGo.await();
                } catch (InterruptedException nobodyDoes) {
                    throw new AssertionError(nobodyDoes);
                }
            }
        };
        WriteBehind first = new WriteBehind(slow);
        first.write(new byte[10], 0, 10);
        assertTrue(stuck.await(10, TimeUnit.SECONDS));
        Sink sink = new Sink();
        try (WriteBehind second = new WriteBehind(sink)) {
            for (int k = 0; k < 100; k++) {
                second.write(new byte[5000], 0, 5000);
            }
        }
        assertEquals(500_000, sink.bytes.size());
        letGo.countDown();
        first.close();
    }

    /** While the file is busy with the first line, at most 64 KiB wait behind it, and then the writer does. */
    @Test
    void notMoreThanItsCapacityWaits() throws Exception {
        Thread[] writer = new Thread[1];
        int[] most = new int[1];
        Sink sink = new Sink() {
            @Override
            public synchronized void write(byte[] source, int from, int count) throws IOException {
                boolean first = most[0] == 0;
                most[0] = Math.max(most[0], count);
                while (first && writer[0] != Thread.currentThread() && writer[0].getState() == Thread.State.RUNNABLE) {
                    Thread.onSpinWait();
                }
                super.write(source, from, count);
            }
        };
        writer[0] = new Thread(() -> {
            try (WriteBehind out = new WriteBehind(sink)) {
                for (int line = 0; line < 300; line++) {
                    out.write(new byte[1000]);
                }
            } catch (IOException problem) {
                throw new AssertionError(problem);
            }
        });
        writer[0].start();
        writer[0].join();

        assertEquals(300_000, sink.bytes.size());
        assertTrue(most[0] <= 1 << 16, most[0] + " bytes at once");
    }
}
