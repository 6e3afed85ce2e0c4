package steward.cli.resident;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.ToIntBiFunction;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.streams.Streams;

/** A session whose client is this test, and whose command is a few lines. */
class SessionTest {

    private static final String CALL = "000referee\0-p1\0\0";

    @TempDir
    private Path folder;
    private SocketChannel client;
    private DataInputStream in;
    private Thread session;

    private void start(ToIntBiFunction<Streams, String[]> program) throws IOException {
        Path socket = folder.resolve("s");
        try (ServerSocketChannel server = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            server.bind(UnixDomainSocketAddress.of(socket));
            client = SocketChannel.open(UnixDomainSocketAddress.of(socket));
            SocketChannel other = server.accept();
            session = new Thread(() -> {
                try {
                    new Session(other, program).serve(Files.getOwner(socket));
                } catch (IOException gone) {
                    // The client has gone.
                    return;
                }
            });
            session.start();
        }
        in = new DataInputStream(Channels.newInputStream(client));
    }

    @AfterEach
    void close() throws IOException, InterruptedException {
        client.close();
        session.join(TimeUnit.SECONDS.toMillis(30));
        assertTrue(!session.isAlive(), "the session ends with its client");
    }

    private void send(char type, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        client.write(ByteBuffer.allocate(5 + bytes.length).put((byte) type).putInt(bytes.length).put(bytes).flip());
    }

    private void assertNext(char type, String text) throws IOException {
        assertEquals(type, (char) in.readByte());
        assertEquals(text, new String(in.readNBytes(in.readInt()), StandardCharsets.ISO_8859_1));
    }

    @Test
    void wordsAndTerminalsComeAsTheyAre() throws IOException {
        CompletableFuture<String[]> words = new CompletableFuture<>();
        start((streams, given) -> {
            words.complete(given);
            return streams.inTerminal() || streams.outTerminal() || !streams.errTerminal() ? 1 : 7;
        });
        send('A', CALL.replaceFirst("000", "001"));

        assertNext('X', "\7");
        assertArrayEquals(new String[] {"referee", "-p1", ""}, words.join());
    }

    @Test
    void outputIsWrittenWhenItIsFlushed() throws IOException {
        start((streams, words) -> {
            streams.out().print("one");
            streams.out().flush();
            streams.err().print("two");
            streams.err().flush();
            return streams.outProblem() == null ? 0 : 1;
        });
        send('A', CALL);

        assertNext('O', "one");
        send('o', "");
        assertNext('E', "two");
        send('o', "");
        assertNext('X', "\0");
    }

    @Test
    void outputThatCannotBeWrittenIsAProblemOfTheCommand() throws IOException {
        start((streams, words) -> {
            streams.out().print("lost");
            return "No space left on device".equals(streams.outProblem()) ? 5 : 0;
        });
        send('A', CALL);

        assertNext('O', "lost");
        send('o', "No space left on device");
        assertNext('X', "\5");
    }

    @Test
    void inputIsReadOnlyWhenItIsAskedFor() throws IOException {
        start((streams, words) -> {
            try {
                return streams.in().read() + streams.in().read() + streams.in().read();
            } catch (IOException problem) {
                return 1;
            }
        });
        send('A', CALL);

        assertNext('I', "");
        send('i', "\1\2");
        assertNext('I', "");
        send('i', "");
        assertNext('X', "\2");                       // 1 + 2, and -1 at the end
    }

    /** Also where the signal comes before the command has said what is to be done at its end: that once hung. */
    @RepeatedTest(20)
    void aSignalInterruptsTheCommandAndIsItsStatus() throws IOException {
        CountDownLatch never = new CountDownLatch(1);
        CompletableFuture<Boolean> interrupted = new CompletableFuture<>();
        CompletableFuture<Boolean> hooked = new CompletableFuture<>();
        start((streams, words) -> {
            streams.hooks().add(new Thread(() -> hooked.complete(true)));
            try {
                never.await();
            } catch (InterruptedException expected) {
                interrupted.complete(true);
            }
            streams.out().print("not sent any more");
            streams.out().flush();
            return 1;
        });
        send('A', CALL);
        send('s', "\17");                            // SIGTERM

        assertNext('X', "\217");                     // 143
        assertTrue(interrupted.orTimeout(30, TimeUnit.SECONDS).join() && hooked.orTimeout(30, TimeUnit.SECONDS).join());
    }

    @Test
    void aClientThatGoesEndsTheCommand() throws IOException, InterruptedException {
        CountDownLatch begun = new CountDownLatch(1);
        CompletableFuture<Boolean> interrupted = new CompletableFuture<>();
        start((streams, words) -> {
            begun.countDown();
            try {
                new CountDownLatch(1).await();
            } catch (InterruptedException expected) {
                interrupted.complete(true);
            }
            return 0;
        });
        send('A', CALL);
        begun.await();
        client.close();

        assertTrue(interrupted.orTimeout(30, TimeUnit.SECONDS).join());
    }

    @Test
    void otherCommandsAreNotServed() throws IOException {
        start((streams, words) -> 0);
        send('A', "000league\0run\0");

        assertThrows(EOFException.class, () -> in.readByte());
    }
}
