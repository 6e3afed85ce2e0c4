package steward.cli.replay;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.stream.Stream;
import steward.bot.isolation.SandboxLevel;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Colour;
import steward.replay.ReplayReader;
import steward.replay.sign.SignerKey;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.SignatureCheck;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;
import steward.text.TextFormat;

/**
 * Report on the verification of a replay: what was compared, and the first difference.
 *
 * @param partial whether agreement up to a cut suffices
 * @param file    of the key that must have signed, or {@code null}
 * @param key     that key, or {@code null}
 * @param least   the level at which bots must have been kept apart at least, or {@code null}
 * @param quiet   whether only what does not agree is printed
 * @param views   of a server, as the verification has compared them
 */
record VerifyReport(PrintStream out, Colour colour, boolean partial, Path file, SignerKey key,
                    SandboxLevel least, boolean quiet, ViewComparison views) {

    /** Characters of a server's line that are printed. */
    private static final int LONGEST = 1000;

    /** @return the exit status */
    int print(ReplayReader replay, Verification verification) {
        String wrong = wrong(replay, verification);
        if (wrong != null) {
            out.println(TextFormat.plain(wrong).replaceFirst("^differs:|^not verified:", colour.bad("$0")));
            ReplayDifference difference = verification.difference();
            if (difference != null && difference.lines() != null) {
                ReplayDifference.Lines lines = difference.lines();
                out.println("  server: " + TextFormat.plain(TextFormat.beginning(lines.server(), LONGEST)));
                out.println("  here:   " + TextFormat.plain(TextFormat.beginning(lines.ours(), LONGEST)));
            }
            shown();
            return status(wrong, verification);
        }
        boolean verified = verification.verified();
        if (!quiet || !verified && !partial) {
            boolean start = !verification.whole() && verification.turns() == 0;
            out.println((verified ? colour.good("verified:") : colour.warning("verified up to the cut:")) + " "
                + (start ? "only the start, since no turn was recorded" : compared(replay, verification))
                + (verification.whole() ? " and the result" : ""));
            shown();
            SignatureCheck signature = verification.signature();
            if (signature.verdict() == SignatureCheck.Verdict.RIGHT) {
                out.println("signed by " + signature.signer()
                    + (key == null ? ", not checked against anyone" : ", the key of " + file));
                if (signature.isolation() != null) {
                    out.println("bots kept apart: " + TextFormat.plain(signature.isolation()));
                }
            } else if (signature.verdict() == SignatureCheck.Verdict.CUT_OFF) {
                out.println("unsigned up to the cut: the signature by " + signature.signer() + " is missing");
            }
        }
        return status(wrong, verification);
    }

    /** The exit status, where this is wrong or {@code null}. */
    int status(String wrong, Verification verification) {
        return wrong == null && (verification.verified() || partial) ? ExitStatus.DONE : ExitStatus.FAILED;
    }

    /** Returns why the replay is not verified, cut off or not; or {@code null}. */
    String wrong(ReplayReader replay, Verification verification) {
        if (replay.header() == null) {
            return "not verified: the header is cut off";
        }
        if (verification.olderLaw() != null) {
            return "not verified: of an older law, not compared: " + verification.olderLaw();
        }
        if (verification.difference() != null) {
            return "differs: " + verification.difference();
        }
        SignatureCheck signature = verification.signature();
        if (signature.verdict() == SignatureCheck.Verdict.WRONG) {
            return "not verified: the signature is not that of " + signature.signer() + " for these lines";
        }
        if (key != null && !signature.isBy(key)) {
            String found = switch (signature.verdict()) {
                case UNSIGNED -> "the replay is unsigned";
                case CUT_OFF -> "the replay was cut off before its signature";
                default -> "the replay is signed by " + signature.signer();
            };
            return "not verified: " + found + ", expected a signature by " + key + ", the key of " + file;
        }
        String weaker = least == null ? null : weaker(signature.isolation());
        if (weaker != null) {
            return "not verified: " + weaker + ", expected it to say at least " + least.word();
        }
        return verification.whole() && verification.states() == 0
            ? "not verified: " + compared(replay, verification) + " were recorded" : null;
    }

    /** Returns why a signature does not say that bots were kept apart as demanded, or {@code null} if it does. */
    private String weaker(String isolation) {
        if (isolation == null) {
            return "the signature does not say how bots were kept apart, as those of earlier versions do not";
        }
        String level = isolation.split(",")[0];
        return Stream.of(SandboxLevel.values()).anyMatch(each -> each.compareTo(least) >= 0
            && each.word().equals(level)) ? null : "the signature says that bots were kept apart at level " + level;
    }

    private void shown() {
        if (!views.notCompared().isEmpty()) {
            out.println("views: " + views.values() + " numbers and words equal"
                + (views.nearInAll() == 0 ? "" : ", " + views.nearInAll() + " within 1e-9 of ours"
                    + (views.nearInAll() > views.near().size() ? ", the first of them:" : ":")));
            views.near().forEach(near -> out.println("  " + near));
            out.println("not compared: " + String.join("; ", views.notCompared()));
        }
    }

    private static String compared(ReplayReader replay, Verification verification) {
        return "states of " + verification.states() + " of " + TextFormat.count(verification.turns(), "turn")
            + (replay.imported() ? ", as another referee saw them,"
            : verification.states() < verification.turns() ? ", hashes of all" : "");
    }
}
