package steward.machines.broker;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.net.ssl.SSLSocket;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.client.ClientMessage;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import steward.bot.process.JavaProcess;

/**
 * Attacks a broker in a process of its own by many clients at the same time, with and without a token, while two honest
 * workers say something and wait for the answer, again and again. Exit status 1 if one of them once waits for longer
 * than half a minute, or the broker ends.
 *
 * <p>{@code --clients N} (100), {@code --seconds N} (60), {@code --heap MB} of the broker (256).
 */
public final class HostileClients {

    static final byte[] PREAMBLE = "ARTEMIS".getBytes(StandardCharsets.US_ASCII);
    static final byte CREATE_SESSION = -18;
    private static final int CHUNK = 1 << 16;
    private static final int HEAVY = 4 << 20;
    private static final long PATIENCE_MS = 30_000;
    private static final List<String> HONEST = List.of("one", "two");

    private final ServedBroker served;
    private final Process broker;
    private final Map<Attack, AtomicInteger> attacks = new EnumMap<>(Attack.class);
    private final AtomicInteger answers = new AtomicInteger();
    private final AtomicInteger longest = new AtomicInteger();
    private volatile String problem;
    private volatile boolean over;

    /** Attack of a client, repeated until the broker closes its connection. */
    private enum Attack {
        LONG_FRAME, NO_LOGIN, WEB, LARGE_MESSAGE, TRANSACTION, SCHEDULED
    }

    private HostileClients(ServedBroker served, Process broker) {
        this.served = served;
        this.broker = broker;
        Stream.of(Attack.values()).forEach(attack -> attacks.put(attack, new AtomicInteger()));
    }

    /** Attacks and prints; or is the broker, with {@code --serve FOLDER CLIENTS}. */
    public static void main(String[] arguments) throws Exception {
        List<String> options = List.of(arguments);
        if (options.contains("--serve")) {
            serve(Path.of(options.get(1)), Integer.parseInt(options.get(2)));
            return;
        }
        String problem = play(Files.createTempDirectory("hostile-clients-"), option(options, "--clients", 100),
            option(options, "--seconds", 60), option(options, "--heap", 256), System.out::println);
        System.out.println(problem == null ? "0 problems" : "PROBLEM: " + problem);
        System.exit(problem == null ? 0 : 1);
    }

    private static int option(List<String> options, String name, int otherwise) {
        int place = options.indexOf(name);
        return place < 0 ? otherwise : Integer.parseInt(options.get(place + 1));
    }

    private static String name(int client) {
        return "hostile" + client;
    }

    private static List<String> workers(int clients) {
        return Stream.concat(HONEST.stream(), IntStream.range(0, clients).mapToObj(HostileClients::name)).toList();
    }

    /** Answers what honest workers say, until its input ends; then prints how much heap it has taken. */
    private static void serve(Path folder, int clients) throws Exception {
        try (ServedBroker served = new ServedBroker(folder, LeagueBroker.QUOTA, workers(clients))) {
            System.out.println(served.port());
            while (System.in.available() == 0) {
                LeagueBroker.Report report = served.broker.next(200);
                if (report != null && HONEST.contains(report.worker())) {
                    served.broker.tell(report.worker(), report.bytes());
                }
            }
        }
        System.out.println(ManagementFactory.getMemoryPoolMXBeans().stream().map(MemoryPoolMXBean::getPeakUsage)
            .mapToLong(usage -> usage.getUsed()).sum() >> 20);
    }

    /**
     * Plays.
     *
     * @param heap of the broker, in MB
     * @return what is not as it should be, or {@code null}
     */
    static String play(Path folder, int clients, int seconds, int heap, Consumer<String> teller) throws Exception {
        ServedBroker.prepared(folder, workers(clients).toArray(String[]::new));
        Process broker = new ProcessBuilder(JavaProcess.words(List.of("-Xmx" + heap + "m"), HostileClients.class,
            List.of("--serve", folder.toString(), Integer.toString(clients))))
            .redirectError(folder.resolve("broker.err").toFile()).start();
        try (BufferedReader said = new BufferedReader(new InputStreamReader(broker.getInputStream(),
                StandardCharsets.UTF_8))) {
            HostileClients all = new HostileClients(new ServedBroker(folder, Integer.parseInt(said.readLine())),
                broker);
            all.run(clients, seconds);
            all.attacks.forEach((attack, count) -> teller.accept(attack + ": " + count));
            teller.accept("answers to honest workers: " + all.answers + ", the longest after " + all.longest + " ms");
            broker.getOutputStream().write('\n');
            broker.getOutputStream().flush();
            teller.accept("memory of the broker: at most " + said.readLine() + " MB, heap " + heap + " MB");
            return all.problem;
        } finally {
            broker.destroyForcibly().waitFor();
        }
    }

    private void run(int clients, int seconds) throws InterruptedException {
        List<Thread> threads = new ArrayList<>();
        HONEST.forEach(worker -> threads.add(new Thread(() -> honest(worker), worker)));
        for (int client = 0; client < clients; client++) {
            String worker = name(client);
            Attack attack = Attack.values()[client % Attack.values().length];
            threads.add(new Thread(() -> hostile(worker, attack), worker));
        }
        threads.forEach(thread -> thread.setDaemon(true));
        threads.subList(0, HONEST.size()).forEach(Thread::start);
        while (answers.get() < HONEST.size() && problem == null && broker.isAlive()) {
            TimeUnit.MILLISECONDS.sleep(20);
        }
        int before = answers.get();
        threads.subList(HONEST.size(), threads.size()).forEach(Thread::start);
        for (int second = 0; second < seconds && problem == null; second++) {
            TimeUnit.SECONDS.sleep(1);
            problem = broker.isAlive() ? problem : "the broker has ended";
        }
        over = true;
        for (Thread thread : threads.subList(0, HONEST.size())) {
            thread.join(2 * PATIENCE_MS);
        }
        problem = problem == null && answers.get() == before ? "no honest worker was answered" : problem;
    }

    private void honest(String worker) {
        long began = System.nanoTime();
        while (!over && problem == null) {
            try (BrokerClient client = served.client(worker, "honest")) {
                for (int number = 0; !over && problem == null; number++) {
                    String said = Integer.toString(number);
                    client.say(said.getBytes(StandardCharsets.US_ASCII));
                    byte[] answer = null;
                    while (!said.equals(answer == null ? null : new String(answer, StandardCharsets.US_ASCII))) {
                        answer = client.listen(200);
                        check(worker, began);
                    }
                    longest.accumulateAndGet(check(worker, began), Math::max);
                    answers.incrementAndGet();
                    began = System.nanoTime();
                }
            } catch (BrokerClient.BrokenException again) {
                check(worker, began);
            }
        }
    }

    private int check(String worker, long began) {
        int millis = (int) TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
        problem = millis > PATIENCE_MS ? worker + " has waited for " + millis + " ms" : problem;
        return millis;
    }

    private void hostile(String worker, Attack attack) {
        while (!over) {
            try {
                attack(worker, attack);
            } catch (Exception closed) {
                // as it should be
            }
            attacks.get(attack).incrementAndGet();
        }
    }

    private void attack(String worker, Attack attack) throws Exception {
        switch (attack) {
            case LONG_FRAME -> flood(frame(Integer.MAX_VALUE, CREATE_SESSION));
            case WEB -> flood("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 2000000000\r\n\r\n"
                .getBytes(StandardCharsets.US_ASCII));
            case NO_LOGIN -> {
                try (SSLSocket socket = served.stranger()) {
                    socket.getOutputStream().write(PREAMBLE);
                    socket.getInputStream().read();
                }
            }
            default -> send(worker, attack);
        }
    }

    private void flood(byte[] first) throws Exception {
        try (SSLSocket socket = served.stranger(); OutputStream out = socket.getOutputStream()) {
            out.write(first);
            while (!over) {
                out.write(new byte[CHUNK]);
            }
        }
    }

    private void send(String worker, Attack attack) throws Exception {
        try (ServerLocator locator = served.locator(worker).setProducerWindowSize(-1).setMinLargeMessageSize(
                attack == Attack.LARGE_MESSAGE ? 1000 : Integer.MAX_VALUE);
             ClientSessionFactory factory = locator.createSessionFactory()) {
            ClientSession session = factory.createSession(worker, served.token(worker).secret(), false,
                attack != Attack.TRANSACTION, true, false, 0);
            try (ClientProducer producer = session.createProducer(Queues.REPORTS)) {
                while (!over) {
                    producer.send(message(session, attack));
                }
            }
        }
    }

    private static ClientMessage message(ClientSession session, Attack attack) throws ActiveMQException {
        ClientMessage message = session.createMessage(false);
        if (attack == Attack.LARGE_MESSAGE) {
            message.setBodyInputStream(new InputStream() {
                @Override
                public int read() throws IOException {
                    return 'x';
                }
            });
        } else if (attack == Attack.SCHEDULED) {
            message.putLongProperty("_AMQ_SCHED_DELIVERY", Long.MAX_VALUE);
        } else {
            message.getBodyBuffer().writeBytes(new byte[HEAVY]);
        }
        return message;
    }

    static byte[] frame(int length, byte type) {
        return ByteBuffer.allocate(12).put(PREAMBLE).putInt(length).put(type).array();
    }
}
