package steward.cli.resident;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.attribute.UserPrincipal;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.ToIntBiFunction;
import jdk.net.ExtendedSocketOptions;
import steward.cli.streams.EndHooks;
import steward.cli.streams.Streams;

/**
 * One client's call to a resident, whose command runs on a thread of its own with the client's streams. The command is
 * broken off if the client sends a signal or is gone. {@code client.c} describes the frames between both.
 */
final class Session {

    /** The commands that a client may call: what others do when they are ended is up to a process of their own. */
    static final Set<String> COMMANDS = Set.of("referee", "play");

    private static final int MOST_BYTES = 1 << 16;
    private static final int STREAMS = 3;
    /** The status of a command that a signal has ended, without the signal's number. */
    private static final int SIGNALLED = 128;
    /** How long a command may take to notice an interruption before there is another, in milliseconds. */
    private static final long PATIENCE_MS = 500;
    private static final byte[] NOTHING = {};

    private final SocketChannel client;
    private final ToIntBiFunction<Streams, String[]> program;
    private final BlockingQueue<byte[]> written = new LinkedBlockingQueue<>();
    private final BlockingQueue<Frame> inputs = new LinkedBlockingQueue<>();
    private final Set<Thread> hooks = new HashSet<>();
    private volatile boolean over;

    private record Frame(char type, byte[] bytes) {

        String text() {
            return new String(bytes, StandardCharsets.UTF_8);
        }
    }

    Session(SocketChannel client, ToIntBiFunction<Streams, String[]> program) {
        this.client = client;
        this.program = program;
    }

    /**
     * Serves the client until it has gone, and its command with it.
     *
     * @param user whose clients are served; those of others are not listened to
     * @throws IOException if the client has gone, or is none
     */
    void serve(UserPrincipal user) throws IOException {
        try (client) {
            if (!client.getOption(ExtendedSocketOptions.SO_PEERCRED).user().equals(user)) {
                return;
            }
            DataInputStream in = new DataInputStream(Channels.newInputStream(client));
            Frame call = next(in);
            List<String> words = call.type() != 'A' || call.bytes().length < STREAMS ? List.of()
                : List.of(call.text().substring(STREAMS).split("\0", -1));
            if (words.isEmpty() || !COMMANDS.contains(words.get(0))) {
                return;
            }
            String[] arguments = words.subList(0, words.size() - 1).toArray(new String[0]);    // behind the last NUL
            Streams streams = new Streams(new Input(), call.bytes()[0] == '1', new Output('O'), new Output('E'),
                call.bytes()[1] == '1', call.bytes()[2] == '1', new Hooks());
            Thread command = new Thread(() -> end(program.applyAsInt(streams, arguments)), "steward-command");
            command.start();
            try {
                for (Frame frame = next(in); ; frame = next(in)) {
                    switch (frame.type()) {
                        case 'i', 'x' -> inputs.add(frame);
                        case 'o' -> written.add(frame.bytes());
                        case 's' -> {
                            breakOff(command);
                            send('X', new byte[] {(byte) (SIGNALLED + frame.bytes()[0])}, 1);
                        }
                        default -> throw new IOException("found a frame '" + frame.type() + "', expected i, x, o or s");
                    }
                }
            } finally {
                breakOff(command);
            }
        }
    }

    private static Frame next(DataInputStream in) throws IOException {
        char type = (char) in.readUnsignedByte();
        int length = in.readInt();
        Objects.checkIndex(length, MOST_BYTES + 1);
        byte[] bytes = in.readNBytes(length);
        if (bytes.length < length) {
            throw new EOFException();
        }
        return new Frame(type, bytes);
    }

    private void end(int status) {
        try {
            if (!over) {
                send('X', new byte[] {(byte) status}, 1);
            }
        } catch (IOException gone) {
            // Nobody is left who would want to know.
            return;
        }
    }

    private synchronized void send(char type, byte[] bytes, int count) throws IOException {
        ByteBuffer frame = ByteBuffer.allocate(1 + Integer.BYTES + count).put((byte) type).putInt(count)
            .put(bytes, 0, count).flip();
        while (frame.hasRemaining()) {
            client.write(frame);
        }
    }

    /** Ends the command and waits for that: its bots have been killed then, and its files closed. */
    private void breakOff(Thread command) {
        synchronized (hooks) {
            over = true;
            hooks.forEach(Thread::start);
            hooks.clear();
        }
        while (command.isAlive()) {
            command.interrupt();
            try {
                command.join(PATIENCE_MS);
            } catch (InterruptedException nobodyDoes) {
                return;
            }
        }
    }

    private static <T> T await(BlockingQueue<T> answers) throws IOException {
        try {
            return answers.take();
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException("interrupted");
        }
    }

    /** A stream of the client: a write has been done when it returns. */
    private final class Output extends OutputStream {

        private final char type;

        Output(char type) {
            this.type = type;
        }

        @Override
        public void write(int each) throws IOException {
            write(new byte[] {(byte) each}, 0, 1);
        }

        @Override
        public synchronized void write(byte[] bytes, int from, int count) throws IOException {
            for (int at = from; at < from + count && !over; at += MOST_BYTES) {
                int length = Math.min(MOST_BYTES, from + count - at);
                String problem;
                synchronized (written) {                     // one answer is awaited at a time, for both streams
                    send(type, Arrays.copyOfRange(bytes, at, at + length), length);
                    problem = new String(await(written), StandardCharsets.UTF_8);
                }
                if (!problem.isEmpty()) {
                    throw new IOException(problem);
                }
            }
        }
    }

    /** The client's input, of which it reads no more than is asked for. */
    private final class Input extends InputStream {

        private ByteBuffer rest = ByteBuffer.wrap(NOTHING);

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] into, int from, int count) throws IOException {
            if (count == 0) {
                return 0;
            }
            if (!rest.hasRemaining()) {
                send('I', NOTHING, 0);
                Frame frame = await(inputs);
                if (frame.type() == 'x') {
                    throw new IOException(frame.text());
                }
                if (frame.bytes().length == 0) {
                    return -1;
                }
                rest = ByteBuffer.wrap(frame.bytes());
            }
            int read = Math.min(count, rest.remaining());
            rest.get(into, from, read);
            return read;
        }

        @Override
        public int available() {
            return rest.remaining();
        }
    }

    private final class Hooks implements EndHooks {

        /** At once, if the command is being broken off: it cannot know that yet. */
        @Override
        public void add(Thread hook) {
            synchronized (hooks) {
                if (over) {
                    hook.start();
                } else {
                    hooks.add(hook);
                }
            }
        }

        @Override
        public void remove(Thread hook) {
            synchronized (hooks) {
                hooks.remove(hook);
            }
        }
    }
}
