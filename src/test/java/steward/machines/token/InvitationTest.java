package steward.machines.token;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.InputException;
import steward.league.LeagueFolder;

/** Machines that come by themselves, with one invitation for all of them. */
@Tag("process")
class InvitationTest {

    private static final Instant NOW = Instant.parse("2026-11-25T12:00:00Z");

    @TempDir
    private Path folder;

    private LeagueFolder league() {
        return new LeagueFolder(folder);
    }

    @BeforeEach
    void putKey() throws IOException {
        SharedBrokerKey.put(league());
    }

    private Invitation.Letter invite(int count) {
        Path file = folder.resolve("invitation.token");
        WorkerList.invite(league(), "invitation", count, NOW.plusSeconds(60), file);
        return Invitation.letter(file);
    }

    private WorkerToken machine(Invitation.Letter letter, String host) {
        return WorkerToken.invited(letter, folder.resolve("keys").resolve(host + ".token"), host);
    }

    private String enrol(WorkerToken token, Instant now) {
        return WorkerList.enrol(league(), token.worker(), token.secret(), token.invitation(), now);
    }

    @Test
    void eachMachineMakesAKeyOfItsOwnAndIsRevokedAlone() throws IOException {
        Invitation.Letter letter = invite(2);
        WorkerToken one = machine(letter, "attic.example.org");
        WorkerToken two = machine(letter, "cellar");
        assertTrue(one.worker().matches("attic-[0-9a-f]{6}"), one.worker());
        assertNotEquals(one.secret(), two.secret());
        assertEquals(one, machine(letter, "attic.example.org"), "the key is kept");
        assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(
            folder.resolve("keys/cellar.token"))));
        assertNull(enrol(one, NOW));
        assertNull(enrol(two, NOW));
        WorkerList list = WorkerList.read(league());
        assertTrue(list.admits(one.worker(), one.secret()) && list.admits(two.worker(), two.secret()));
        assertFalse(list.admits(one.worker(), letter.secret()), "an invitation is no token");
        assertEquals(2, list.used(list.invitation("invitation").orElseThrow()));
        String text = Files.readString(folder.resolve("machines/workers.json"));
        assertFalse(text.contains(one.secret()) || text.contains(letter.secret()), text);

        WorkerList.revoke(league(), one.worker(), "by hand", false);
        list = WorkerList.read(league());
        assertFalse(list.admits(one.worker(), one.secret()));
        assertTrue(list.admits(two.worker(), two.secret()));
        assertTrue(enrol(one, NOW).endsWith("is revoked, or another machine has this name"), "not with the invitation");
    }

    @Test
    void anInvitationIsRefusedWhenItIsUsedUpExpiredRevokedOrUnknown() {
        Invitation.Letter letter = invite(1);
        assertNull(enrol(machine(letter, "a"), NOW));
        assertEquals("the invitation invitation is used up: 1 of 1 machines have joined with it",
            enrol(machine(letter, "b"), NOW));
        assertEquals("the invitation invitation has expired: it was good until 2026-11-25T12:01:00Z",
            enrol(machine(letter, "b"), NOW.plusSeconds(61)));
        WorkerList.revoke(league(), "invitation", "by hand", false);
        assertEquals("the invitation invitation is revoked", enrol(machine(letter, "b"), NOW));
        assertEquals("the invitation is unknown", WorkerList.enrol(league(), "b", "x", "x", NOW));
        assertEquals(1, WorkerList.read(league()).workers().size());
        assertThrows(InputException.class, () -> invite(1), "the name is taken");
    }

    @Test
    void damagedInvitationsAndKeysOfOtherLeaguesAreNamed() throws IOException {
        Invitation.Letter letter = invite(1);
        Path file = folder.resolve("invitation.token");
        Files.writeString(file, Files.readString(file).replace("\"name\"", "\"nome\""));
        String said = assertThrows(InputException.class, () -> Invitation.letter(file)).getMessage();
        assertTrue(said.startsWith(file + ":1:"), said);
        machine(letter, "a");
        Invitation.Letter other = new Invitation.Letter("other", letter.secret(), "0".repeat(64));
        said = assertThrows(InputException.class, () -> machine(other, "a")).getMessage();
        assertTrue(said.contains("found the key for another league"), said);
        assertThrows(InputException.class, () -> Invitation.until("2026-11-24", NOW));
        assertThrows(InputException.class, () -> Invitation.until("tomorrow", NOW));
        assertTrue(Invitation.until("2026-11-27", NOW).isAfter(NOW));
    }
}
