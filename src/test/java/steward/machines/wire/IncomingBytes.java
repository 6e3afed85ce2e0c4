package steward.machines.wire;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import steward.bot.command.Platform;
import steward.files.InputException;
import steward.machines.bundle.Bundle;
import steward.machines.bundle.UnpackedBundle;
import steward.scene.json.SceneException;

/**
 * Bytes from other machines, broken by chance: messages of workers and leagues, jobs, bundles. Each has to be taken or
 * refused with one message, and a bundle must write nothing outside its folder.
 */
public final class IncomingBytes {

    private static final String HASH = "0123456789abcdef".repeat(4);
    private static final List<byte[]> WORDS = List.of(
        WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "1").put("bits", "0123456789abcdef")
            .put("machine", "a machine").put("slots", 2)),
        WireMessage.bytes(new HeaderText().put("type", "fetch").put("bundle", HASH).put("from", 262_144)),
        new WorkerWord.Result(HASH.substring(32), List.of(new WorkerWord.Played(List.of(new byte[] {1, 2, 3},
            new byte[] {4, 5}), List.of(true, false), null, null), new WorkerWord.Played(List.of(new byte[] {6}),
                List.of(false), "no", null))).bytes(),
        WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle", HASH).put("reason", "no python3")),
        WireMessage.bytes(new HeaderText().put("type", "differs").put("rules", "0123456789abcdef")));
    private static final GameJob.Seat ONE = new GameJob.Seat("a", HASH, 99, null);
    private static final GameJob.Seat OTHER = new GameJob.Seat("b", HASH, 1, null);
    private static final byte[] JOB = new GameJob(HASH.substring(32), List.of(new GameJob.Game(-7, List.of(ONE, OTHER)),
        new GameJob.Game(8, List.of(OTHER, ONE)))).bytes();

    private static final List<byte[]> LEAGUE_WORDS = List.of(
        WireMessage.bytes(new HeaderText().put("type", "welcome").put("version", "1").put("rules", "0123456789abcdef")
            .put("factor", "1.5").put("basis", "cpu").put("hiccups", "replay").put("hold", "burners"),
            "{}".getBytes(StandardCharsets.UTF_8)),
        WireMessage.bytes(new HeaderText().put("type", "refused").put("reason", "found 1, expected 2")),
        WireMessage.bytes(new HeaderText().put("type", "bundle").put("bundle", HASH).put("from", 262_144)
            .put("known", true), new byte[] {1, 2, 3}));

    private final Path folder;
    private final long seed;

    /** @param folder for bundles */
    public IncomingBytes(Path folder, long seed) {
        this.folder = folder;
        this.seed = seed;
    }

    private SplittableRandom random(int number) {
        return new SplittableRandom(seed * 1_000_003 + number);
    }

    /** Some bytes changed, cut out, doubled or put in. */
    private static byte[] broken(byte[] original, SplittableRandom random) {
        byte[] bytes = original.clone();
        for (int change = 1 + random.nextInt(3); change > 0; change--) {
            int at = random.nextInt(bytes.length);
            int length = random.nextInt(Math.min(20, bytes.length - at) + 1);
            byte[] next = new byte[bytes.length + length];
            switch (random.nextInt(4)) {
                case 0 -> bytes[at] = (byte) random.nextInt(256);
                case 1 -> bytes[at] = (byte) "{}[],:\"0123456789-./\\ntrue".charAt(random.nextInt(24));
                case 2 -> {
                    System.arraycopy(bytes, 0, next, 0, at + length);
                    System.arraycopy(bytes, at, next, at + length, bytes.length - at);
                    bytes = next;
                }
                default -> {
                    next = new byte[Math.max(1, bytes.length - length)];
                    System.arraycopy(bytes, 0, next, 0, Math.min(at, next.length));
                    int rest = Math.max(0, next.length - at);
                    System.arraycopy(bytes, bytes.length - rest, next, next.length - rest, rest);
                    bytes = next;
                }
            }
        }
        return bytes;
    }

    private static boolean isRefused(Runnable reading) {
        try {
            reading.run();
            return false;
        } catch (InputException | SceneException problem) {
            String message = String.valueOf(problem.getMessage());
            if (message.isBlank() || message.equals("null")
                || message.matches("(?s).*(Exception|java\\.|tools\\.).*")) {
                throw new AssertionError("a refusal that is not for people: " + message);
            }
            return true;
        }
    }

    /** A message of a worker; whether it is refused. */
    public boolean word(int number) {
        SplittableRandom random = random(number);
        byte[] bytes = broken(WORDS.get(random.nextInt(WORDS.size())), random);
        return isRefused(() -> WorkerWord.read(bytes, "worker one", Bundle.LARGEST));
    }

    /** A job; whether it is refused. */
    public boolean job(int number) {
        byte[] bytes = broken(JOB, random(number));
        return isRefused(() -> GameJob.read(bytes, "the league", Bundle.LARGEST));
    }

    /** Reads a league's message to a worker; true if it is refused. */
    public boolean league(int number) {
        SplittableRandom random = random(number);
        byte[] bytes = broken(LEAGUE_WORDS.get(random.nextInt(LEAGUE_WORDS.size())), random);
        return isRefused(() -> LeagueWord.read(bytes, "the league", Bundle.LARGEST));
    }

    /** A bundle whose hash is right, its names and list broken, or the packed bytes; whether it is refused. */
    public boolean bundle(int number) {
        SplittableRandom random = random(number);
        boolean inside = random.nextBoolean();
        byte[] bytes = archive(random, inside);
        byte[] sent = inside ? bytes : broken(bytes, random);
        Path parent = folder.resolve("bundles");
        try {
            return isRefused(() -> UnpackedBundle.of(parent, hash(sent), sent, Platform.here()));
        } finally {
            lookAround(parent);
        }
    }

    private static byte[] archive(SplittableRandom random, boolean isBroken) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        String list = "{\"command\":[\"python3\",\"bot.py\"],\"files\":[{\"typed\":\"bot.py\",\"place\":"
            + "\"here/bot.py\",\"executable\":true}]}";
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            entry(zip, "bundle.json", isBroken && random.nextBoolean()
                ? broken(list.getBytes(StandardCharsets.UTF_8), random) : list.getBytes(StandardCharsets.UTF_8));
            String[] names = {"here/bot.py", "../bot.py", "/tmp/bot.py", "here/../../bot.py", "here//bot.py",
                "here/./x", "c:\\bot.py", "here/.../x", "a/b/c/d", "bundle.json/x", ""};
            String name = isBroken ? names[random.nextInt(names.length)] : names[0];
            String sent = isBroken && random.nextInt(4) == 0 && !name.isEmpty() ? new String(broken(name.getBytes(
                StandardCharsets.UTF_8), random), StandardCharsets.ISO_8859_1) : name;
            byte[] content = new byte[random.nextInt(50)];
            entry(zip, sent.equals("bundle.json") ? "bundle.jso" : sent, content);     // a stream writes no name twice
        } catch (IOException inMemory) {
            throw new UncheckedIOException(inMemory);
        }
        return bytes.toByteArray();
    }

    private static void entry(ZipOutputStream zip, String name, byte[] content) throws IOException {
        zip.putNextEntry(new ZipEntry(name));
        zip.write(content);
        zip.closeEntry();
    }

    private static String hash(byte[] bytes) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    /** Nothing is there but folders of bundles, whole ones; they are removed. */
    private void lookAround(Path parent) {
        try (Stream<Path> all = Files.list(folder)) {
            List<Path> found = all.toList();
            if (!found.isEmpty() && !found.equals(List.of(parent))) {
                throw new AssertionError("found " + found + ", expected nothing but " + parent);
            }
            if (found.isEmpty()) {
                return;
            }
            try (Stream<Path> inside = Files.walk(parent)) {
                for (Path path : inside.sorted((one, other) -> other.compareTo(one)).toList()) {
                    if (path.getParent().equals(parent) && !path.getFileName().toString().matches("[0-9a-f]{64}")) {
                        throw new AssertionError("found " + path + ", expected folders with hashes");
                    }
                    Files.delete(path);
                }
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }
}
