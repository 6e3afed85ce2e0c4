package steward.guest;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.lang.ref.WeakReference;
import java.lang.reflect.Field;
import java.lang.reflect.InvocationTargetException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarFile;

/**
 * Main class of a JVM that runs referees from a class path, game after game. It needs nothing but the JDK. Blocks go
 * through the JVM's own input and output, which the referee cannot reach: text that the referee prints goes to standard
 * error.
 *
 * <p>A game begins with a block START, whose lines are system properties, and ends with END. The answer is READY, with
 * {@code go on}, or {@code recycle} if many class loaders stay alive or fill the metaspace. Each game has a class
 * loader of its own for the SDK and the contest, unless classes are reused; other libraries are shared. The system
 * class loader has the whole class path too, but only for referees that ask it for files; none of these loaders
 * delegates to it.
 *
 * <p>Arguments: the main class, {@code fresh} or {@code classes}, the entries of the class path.
 */
public final class GuestJvm {

    /** Metaspace in bytes above which a collection is asked for, and above which the JVM is recycled. */
    private static final long COLLECT_ABOVE = 96L << 20;
    private static final long RECYCLE_ABOVE = 192L << 20;
    /** Loaders of earlier games that may stay alive. */
    private static final int MOST_LOADERS = 40;
    /** The first entry is the project itself; of the others, those with such classes are the SDK. */
    private static final String SDK = "com/codingame/";

    private final String main;
    private final boolean reuse;
    private final List<URL> own = new ArrayList<>();
    private final ClassLoader libraries;
    private final List<WeakReference<ClassLoader>> loaders = new ArrayList<>();
    private ClassLoader kept;

    private GuestJvm(String main, boolean reuse, List<String> classPath) throws IOException {
        this.main = main;
        this.reuse = reuse;
        List<URL> shared = new ArrayList<>();
        for (String entry : classPath) {
            Path path = Path.of(entry);
            (own.isEmpty() || isSdk(path) ? own : shared).add(path.toUri().toURL());
        }
        libraries = new URLClassLoader(shared.toArray(new URL[0]), ClassLoader.getPlatformClassLoader());
    }

    private static boolean isSdk(Path path) throws IOException {
        if (Files.isDirectory(path)) {
            return true;
        }
        try (JarFile jar = new JarFile(path.toFile())) {
            return jar.stream().anyMatch(entry -> entry.getName().startsWith(SDK));
        }
    }

    /** Plays until its input ends. */
    public static void main(String[] words) throws IOException {
        Lines in = new Lines(System.in);
        PrintStream out = new PrintStream(System.out, false, StandardCharsets.UTF_8);
        System.setOut(new PrintStream(System.err, true, StandardCharsets.UTF_8));
        System.setIn(InputStream.nullInputStream());
        GuestJvm host = new GuestJvm(words[0], words[1].equals("classes"),
            List.of(words).subList(2, words.length));
        List<String> set = new ArrayList<>();
        for (String head = in.line(); head != null; head = in.line()) {
            if (head.startsWith("[[START]")) {
                set.forEach(System::clearProperty);
                set.clear();
                for (int count = Integer.parseInt(head.replaceAll("\\D", "")); count > 0; count--) {
                    String[] property = in.line().split("=", 2);
                    System.setProperty(property[0], property[1]);
                    set.add(property[0]);
                }
                in.ended = false;
                host.play(in, out);
                while (!in.ended) {
                    in.line();
                }
                out.print("[[READY] 1]\n" + (host.isFull() ? "recycle" : "go on") + "\n");
                out.flush();
            }
        }
    }

    private void play(Lines in, PrintStream out) {
        ClassLoader loader = kept;
        if (loader == null) {
            loader = new URLClassLoader(own.toArray(new URL[0]), libraries);
            loaders.add(new WeakReference<>(loader));
            kept = reuse ? loader : null;
        }
        Thread.currentThread().setContextClassLoader(loader);
        try {
            Class<?> referee = loader.loadClass(main);
            setInProduction(referee);
            referee.getMethod("start", InputStream.class, PrintStream.class).invoke(null, in, out);
        } catch (InvocationTargetException thrown) {
            fail(out, thrown.getCause());
        } catch (Throwable problem) {              // errors too: whatever a referee throws is told as its failure
            fail(out, problem);
        } finally {
            Thread.currentThread().setContextClassLoader(ClassLoader.getSystemClassLoader());
            out.flush();
        }
    }

    /** Sets what the SDK's own main method sets, where it is there. */
    private static void setInProduction(Class<?> referee) {
        try {
            Field field = referee.getDeclaredField("inProduction");
            field.setAccessible(true);
            field.set(null, true);
        } catch (ReflectiveOperationException none) {
            // A main class without it needs nothing.
        }
    }

    private static void fail(PrintStream out, Throwable problem) {
        problem.printStackTrace();
        out.print("[[FAIL] 1]\n" + String.valueOf(problem).replaceAll("\\R", " ") + "\n");
    }

    /** True if loaders of earlier games stay alive, also after a collection: too many, or they fill the metaspace. */
    private boolean isFull() {
        if (metaspace() < COLLECT_ABOVE && loaders.size() < MOST_LOADERS) {
            return false;
        }
        System.gc();
        loaders.removeIf(loader -> loader.get() == null);
        return metaspace() > RECYCLE_ABOVE || loaders.size() >= MOST_LOADERS;
    }

    private static long metaspace() {
        return ManagementFactory.getMemoryPoolMXBeans().stream().filter(pool -> pool.getName().equals("Metaspace"))
            .mapToLong(pool -> pool.getUsage().getUsed()).sum();
    }

    /** The input of one game: a reader gets a line at a time, so that it never takes lines of the next game. */
    private static final class Lines extends InputStream {

        private static final String END = "[[END] 0]";

        private final InputStream in;
        private ByteArrayInputStream current = new ByteArrayInputStream(new byte[0]);
        private boolean ended;

        Lines(InputStream in) {
            this.in = in;
        }

        /** The next line without its end, or {@code null}; END sets {@link #ended}. */
        String line() throws IOException {
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            int one = in.read();
            while (one >= 0 && one != '\n') {
                line.write(one);
                one = in.read();
            }
            String text = one < 0 ? null : line.toString(StandardCharsets.UTF_8);
            ended |= text == null || text.equals(END);
            return text;
        }

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
        }

        @Override
        public int read(byte[] target, int offset, int length) throws IOException {
            if (current.available() == 0) {
                String line = ended ? null : line();
                if (line == null || ended) {
                    return -1;
                }
                current = new ByteArrayInputStream((line + "\n").getBytes(StandardCharsets.UTF_8));
            }
            return current.read(target, offset, length);
        }
    }
}
