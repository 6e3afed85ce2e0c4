package steward.machines.token;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.InputException;
import steward.league.LeagueFolder;

/** Keys and tokens: private, renewable, revocable. */
@Tag("process")
class TokenTest {

    @TempDir
    private Path folder;

    private static String mode(Path file) throws IOException {
        return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
    }

    @Test
    void filesArePrivateAndSecretsAreNotKept() throws IOException {
        LeagueFolder league = new LeagueFolder(folder);
        Path file = folder.resolve("a.token");
        WorkerList.add(league, "a", file);
        WorkerToken token = WorkerToken.read(file);
        assertEquals("rw-------", mode(file));
        assertEquals("rwx------", mode(folder.resolve("machines")));
        assertEquals("rw-------", mode(folder.resolve("machines/workers.json")));
        assertFalse(Files.readString(folder.resolve("machines/workers.json")).contains(token.secret()));
        assertFalse(token.toString().contains(token.secret()));
        assertEquals(null, PrivateFile.warning(file));
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
        assertTrue(PrivateFile.warning(file).endsWith("(rw-r-----), expected a file of yours alone: chmod 600 "
            + file));

        WorkerList list = WorkerList.read(league);
        assertTrue(list.admits("a", token.secret()));
        assertFalse(list.admits("a", token.secret().substring(1) + "x"));
        assertFalse(list.admits("b", token.secret()));
        assertFalse(list.admits(null, null));
        assertThrows(InputException.class, () -> WorkerList.add(league, "a", folder.resolve("b.token")));
        WorkerList.revoke(league, "a", "by \"hand\"\n", false);
        assertFalse(WorkerList.read(league).admits("a", token.secret()));
        assertEquals("by ?hand??", WorkerList.read(league).of("a").orElseThrow().revoked());
        WorkerList.revoke(league, "a", "again", true);
        WorkerList.Worker aside = WorkerList.read(league).of("a").orElseThrow();
        assertEquals("by ?hand?? true", aside.revoked() + " " + aside.aside());
        WorkerList.pardon(league, "a");
        assertTrue(WorkerList.read(league).admits("a", token.secret()));
        assertThrows(InputException.class, () -> WorkerList.pardon(league, "a"), "may play");

        assertTrue(WorkerList.doubt(league, "a", "answers \"otherwise\""));
        assertEquals("answers ?otherwise?", WorkerList.read(league).of("a").orElseThrow().doubt());
        WorkerList.revoke(league, "a", "by hand", false);
        WorkerList.Worker revoked = WorkerList.read(league).of("a").orElseThrow();
        assertTrue(revoked.aside() && revoked.doubt() == null, "its games never count");
        assertFalse(WorkerList.doubt(league, "a", "more"), "it is decided");
        WorkerList.pardon(league, "a");
        WorkerList.doubt(league, "a", "again");
        WorkerList.pardon(league, "a");
        assertFalse(WorkerList.doubt(league, "a", "once more"), "it was pardoned for that");
        assertNull(WorkerList.read(league).of("a").orElseThrow().doubt());
        WorkerList.revoke(league, "a", "by hand", true);
        WorkerList.add(league, "a", folder.resolve("anew.token"));
        assertFalse(WorkerList.read(league).admits("a", token.secret()), "a new token");
        assertTrue(WorkerList.read(league).admits("a", WorkerToken.read(folder.resolve("anew.token")).secret()));
        assertEquals(1, WorkerList.read(league).workers().size());
    }

    /** As earlier versions made it, with the password that stood in the sources, readable by all. */
    @Test
    @Tag("campaign")
    void aStoreOfAnEarlierVersionIsLockedAnewKeepsItsKeyAndIsRenewed() throws Exception {
        LeagueFolder league = new LeagueFolder(folder);
        SharedBrokerKey.put(league);
        WorkerList.add(league, "a", folder.resolve("a.token"));
        BrokerKey key = new BrokerKey(league);
        var certificate = key.certificate();
        Path secret = folder.resolve("machines/broker.password");
        KeyStore keys = KeyStore.getInstance("PKCS12");
        char[] own = key.password().toCharArray();
        char[] former = "steward".toCharArray();
        try (InputStream in = Files.newInputStream(key.store())) {
            keys.load(in, own);
        }
        keys.setKeyEntry("broker", keys.getKey("broker", own), former, keys.getCertificateChain("broker"));
        Files.delete(secret);
        try (OutputStream out = Files.newOutputStream(key.store())) {
            keys.store(out, former);
        }
        key.make();
        assertEquals(certificate, key.certificate());
        assertEquals(key.fingerprint(), WorkerToken.read(folder.resolve("a.token")).broker());
        assertTrue(key.password().matches("[0-9a-f]{64}") && !key.password().equals(new String(own)));
        for (Path file : List.of(secret, key.store())) {
            assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
        }
        assertThrows(IOException.class, () -> {
            try (InputStream in = Files.newInputStream(key.store())) {
                keys.load(in, former);
            }
        });
        String fingerprint = key.fingerprint();
        assertTrue(fingerprint.matches("[0-9a-f]{64}"));
        key.renew();
        assertNotEquals(certificate, key.certificate());
        assertEquals(fingerprint, key.fingerprint());
        Files.delete(secret);
        assertTrue(assertThrows(InputException.class, key::make).getMessage().contains("found no such file"));
    }

    /** The first ones to need the broker's key may be several at once: a worker is added while the league begins. */
    @Test
    void whoAddsWorkersAtTheSameTimeLosesNoneAndMakesOneKey() throws Exception {
        LeagueFolder league = new LeagueFolder(folder);
        List<CompletableFuture<String>> adding = new ArrayList<>();
        ExecutorService threads = Executors.newFixedThreadPool(4);
        for (String name : List.of("a", "b", "c", "d")) {
            adding.add(CompletableFuture.supplyAsync(() -> {
                WorkerList.add(league, name, folder.resolve(name + ".token"));
                return WorkerToken.read(folder.resolve(name + ".token")).broker();
            }, threads));
        }
        Set<String> keys = new HashSet<>();
        for (CompletableFuture<String> each : adding) {
            keys.add(each.get(60, TimeUnit.SECONDS));
        }
        threads.shutdown();
        assertEquals(Set.of(new BrokerKey(league).fingerprint()), keys);
        assertEquals(List.of("a", "b", "c", "d"), WorkerList.read(league).workers().stream()
            .map(WorkerList.Worker::name).sorted().toList());
    }

    @Test
    void whatIsNoTokenIsRefusedWithoutShowingIt() throws IOException {
        Path file = folder.resolve("t");
        Files.writeString(file, "{\"token\":1,\"worker\":\"a\",\"secret\":\"hunter2\",\"broker\":\"0\"}");
        String said = assertThrows(InputException.class, () -> WorkerToken.read(file)).getMessage();
        assertTrue(said.contains("secret: found a text of 7 characters") && !said.contains("hunter2"), said);
        assertThrows(InputException.class, () -> WorkerToken.read(folder));
        assertThrows(InputException.class, () -> WorkerToken.read(folder.resolve("none")));
    }
}
