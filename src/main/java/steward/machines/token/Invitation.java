package steward.machines.token;

import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.time.format.DateTimeParseException;
import steward.files.InputException;
import steward.scene.json.Block;

/**
 * Invitation to a league, with which a limited number of machines may make keys of their own until it expires.
 *
 * @param name    unlike those of workers and other invitations
 * @param hash    SHA-256 of its secret
 * @param count   machines that may use it
 * @param until   the moment after which it is of no use
 * @param revoked true if no other machine may use it
 */
public record Invitation(String name, String hash, int count, Instant until, boolean revoked) {

    /**
     * File of an invitation, as a machine gets it.
     *
     * @param secret 43 characters of base64url
     * @param broker see {@link BrokerKey#fingerprint()}
     */
    public record Letter(String name, String secret, String broker) {

        /** Returns the letter as it stands in its file. */
        String text() {
            return "{ \"invitation\": 1, \"name\": \"" + name + "\", \"secret\": \"" + secret + "\", \"broker\": \""
                + broker + "\" }\n";
        }

        /** Without the secret. */
        @Override
        public String toString() {
            return "invitation " + name;
        }
    }

    /** Reads the file of an invitation, as below. */
    public static Letter letter(Path file) {
        return letter(PrivateFile.read(file, WorkerToken.EXPECTED), file.toString());
    }

    /**
     * Reads an invitation.
     *
     * @param source names it in errors
     * @return {@code null} if it is the token of one worker
     * @throws InputException if it is no JSON, or a damaged invitation
     */
    public static Letter letter(String text, String source) {
        return PrivateFile.parse(text, source, "a token or an invitation", block -> {
            if (!block.has("invitation")) {
                return null;
            }
            block.integer("invitation", 1, 1);
            return new Letter(WorkerToken.pattern(block, "name", WorkerList.NAME),
                WorkerToken.pattern(block, "secret", WorkerToken.SECRET),
                WorkerToken.pattern(block, "broker", WorkerToken.BROKER));
        });
    }

    static Invitation read(Block block) {
        Instant until;
        try {
            until = Instant.parse(block.text("until"));
        } catch (DateTimeParseException problem) {
            throw block.error("until", block.shown("until"), "a moment such as 2026-12-24T22:59:59Z");
        }
        Invitation invitation = new Invitation(WorkerToken.pattern(block, "name", WorkerList.NAME),
            WorkerToken.pattern(block, "hash", WorkerList.HASH), block.integer("count", 1, WorkerList.MOST), until,
            block.flag("revoked", false));
        block.done();
        return invitation;
    }

    String text() {
        return "{ \"name\": \"" + name + "\", \"hash\": \"" + hash + "\", \"count\": " + count + ", \"until\": \""
            + until + "\"" + (revoked ? ", \"revoked\": true" : "") + " }";
    }

    /** Returns why it is of no use, or {@code null}. @param used machines that have used it */
    String refusal(long used, Instant now) {
        String what = "the invitation " + name;
        if (revoked) {
            return what + " is revoked";
        }
        if (now.isAfter(until)) {
            return what + " has expired: it was good until " + until;
        }
        return used < count ? null : what + " is used up: " + used + " of " + count + " machines have joined with it";
    }

    /**
     * Reads the end of an invitation: a day, to its end, or a moment, in the time zone of this machine.
     *
     * @throws InputException if it is neither, or is over
     */
    public static Instant until(String typed, Instant now) {
        Instant until;
        try {
            until = (typed.contains("T") ? LocalDateTime.parse(typed) : LocalDate.parse(typed).atTime(23, 59, 59))
                .atZone(ZoneId.systemDefault()).toInstant();
        } catch (DateTimeParseException problem) {
            throw new InputException("until", "found '" + typed + "', expected a day such as 2026-12-24 or a moment "
                + "such as 2026-12-24T18:00");
        }
        if (!until.isAfter(now)) {
            throw new InputException("until", "found '" + typed + "', which is over, expected a later day");
        }
        return until;
    }
}
