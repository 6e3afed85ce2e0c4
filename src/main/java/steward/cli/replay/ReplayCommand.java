package steward.cli.replay;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.isolation.SandboxLevel;
import steward.cli.options.OptionSection;
import steward.cli.options.ProgramCommand;
import steward.cli.options.RefereeOption;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.cli.shared.PlayerChoice;
import steward.cli.streams.StandardFiles;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.replay.ReplayReader;
import steward.replay.sign.SignerKey;
import steward.replay.verify.Verification;
import steward.replay.verify.ViewComparison;

/** {@code steward replay}: shows a recorded match, or plays it again and compares. */
@Command(name = "replay", description = "Prints a recorded match turn by turn, or plays it again and compares.",
    footer = {
        "", "A file that was cut off is read up to the cut.",
        "", "--verify plays the match again and compares every line. That proves that states",
        "and result follow from the commands. It does not prove who gave the commands:",
        "names, messages, faults and limits are only as good as the signature, which",
        "--signed-by checks. It prints how many states were compared. --require also",
        "demands that the signature states an isolation level; earlier versions did not",
        "write it. A replay without a result, or without a turn, is \"verified up to the",
        "cut\". Then the exit status is 1 unless --partial is given. For an imported",
        "game, every number and word of the server's views and summaries is compared;",
        "parts that are not compared are listed.",
        "", "--json: scene, game, seed, turns, impacts, ending, winner, players, failures,",
        "warning. With --turn: turn, commands, faults, messages, stderr, outcome as",
        "recorded (angles in radians). With --impacts: turns (turn, impacts). With",
        "--verify: verified, reason (or null), turns, difference (turn, field, recorded,",
        "found, or null), isolation (as signed, or null), warning. An imported game also",
        "has values (how many agree), near (how many agree only to 1e-9) and",
        "notCompared.",
        "", "Examples:",
        "  steward replay match.jsonl --from 10 --to 20",
        "  steward replay match.jsonl --turn 57",
        "  steward replay match.jsonl --impacts",
        "  steward replay match.jsonl --map",
        "  steward replay match.jsonl --verify",
        "  steward replay match.jsonl --verify --signed-by mine.key.pub",
        "  steward replay match.jsonl --verify --signed-by a.pub --require strict",
        "  steward replay match.jsonl --view match.html --open",
        "  steward replay old.jsonl --beside new.jsonl --view both.html",
        "  steward replay match.jsonl --viewer --open",
        "  steward replay match.jsonl --frames --player 1 | ./mybot",
        "", "Exit status: 0 done; 1 not verified: something is missing or differs from the",
        "rules, or the signature is missing or by another key; 2 wrong file or call."})
public final class ReplayCommand extends ProgramCommand {

    private static final double MOST_TURNS = 1e9;

    @Parameters(index = "0", paramLabel = "FILE",
        description = "The replay; - is the standard input.")
    private String file;

    @OptionSection("Looking at a part")
    @Option(names = "--turn", paramLabel = "N", description = "Prints everything about this turn.")
    private Integer turn;

    @OptionSection("Looking at a part")
    @Option(names = "--from", paramLabel = "A", description = "Begins with this turn.")
    private Integer from;

    @OptionSection("Looking at a part")
    @Option(names = "--to", paramLabel = "B", description = "Ends with this turn.")
    private Integer to;

    @OptionSection("Looking at a part")
    @Option(names = "--impacts", description = "Prints the impacts instead of the states.")
    private boolean impacts;

    @OptionSection("Looking at a part")
    @Option(names = "--map", description = "Draws the end of the match with characters.")
    private boolean map;

    @OptionSection("Verifying")
    @Option(names = "--verify", description = "Plays the match again and compares every turn.")
    private boolean verify;

    @Mixin
    private final RefereeOption referee = new RefereeOption();

    @OptionSection("Verifying")
    @Option(names = "--partial", description = "With --verify: accepts what agrees up to a cut.")
    private boolean partial;

    @OptionSection("Verifying")
    @Option(names = "--signed-by", paramLabel = "PUB",
        description = "With --verify: demands that the owner of this public key has signed the replay.")
    private String signedBy;

    @OptionSection("Verifying")
    @Option(names = "--require", paramLabel = "off|light|strict", description = "With --verify and --signed-by: "
        + "demands that the signer says that bots were kept apart at this level at least.")
    private SandboxLevel require;

    @OptionSection("Looking at a part")
    @Option(names = "--frames", description = "Prints the lines that one bot was sent, byte for byte; with --player, "
        + "and --turn for those of one turn.")
    private boolean frames;

    @OptionSection("Looking at a part")
    @Option(names = "--player", paramLabel = "P",
        description = "Which bot: its number, counted from 0, or its name.")
    private String player;

    @OptionSection("Pages and pictures")
    @Option(names = "--view", paramLabel = "HTML",
        description = "Writes a page that shows the match to this file, - for the standard output: everything in it, "
            + "opens from disk.")
    private String view;

    @OptionSection("Pages and pictures")
    @Option(names = "--open", description = "Opens the page of --view, or one without a name, in the browser.")
    private boolean open;

    @OptionSection("Pages and pictures")
    @Option(names = "--beside", paramLabel = "FILE", description = "With --view or --open: another replay of the same "
        + "scene, players and seed. The page shows both side by side, and where they differ.")
    private String beside;

    @OptionSection("Pages and pictures")
    @Option(names = "--viewer", description = "Shows the match of a referee made with CodinGame's SDK in the SDK's own "
        + "viewer, from the jars that the replay names, to browsers on this machine, until Enter.")
    private boolean viewer;

    @OptionSection("Pages and pictures")
    @Option(names = "--site", paramLabel = "URL", description = "With --view: the address the page will have; title, "
        + "description and picture of previews of links are written for it, the picture by a browser on the PATH.")
    private String site;

    @OptionSection("Pages and pictures")
    @Option(names = "--picture", paramLabel = "FILE", description = "Writes a picture of the match at --turn (its end "
        + "if there is none), by a browser on the PATH. A fraction is a moment within a turn: --at 28.66. A name that "
        + "ends in .svg: a moving picture, without a browser, of the whole match or of --from to --to.")
    private String picture;

    @OptionSection("Pages and pictures")
    @Option(names = "--at", paramLabel = "T", description = "With --picture: the moment, in turns.")
    private Double at;

    @OptionSection("Pages and pictures")
    @Option(names = "--overwrite", description = "Replaces a page that exists.")
    private boolean overwrite;

    @Option(names = "--quiet", description = "Prints only the summary; with --verify, only a difference.")
    private boolean quiet;

    @Option(names = "--json", description = "Prints one JSON object instead: the summary, a turn, impacts or the "
        + "verification; see below.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        checkCall();
        boolean piped = StandardFiles.is(file);
        if (moving()) {
            return movingPicture(piped);
        }
        if (viewer) {
            try (ReplayReader replay = piped ? StandardFiles.openReplay(streams) : open(OutputFiles.path(file))) {
                new SdkViewer(replay).serve(streams, open);
                return ExitStatus.DONE;
            }
        }
        if (beside != null) {
            return viewBeside();
        }
        if (view != null || open || picture != null) {
            return view(piped ? null : OutputFiles.path(file), piped ? StandardFiles.readAll(streams) : null);
        }
        Path keyFile = signedBy == null ? null : OutputFiles.path(signedBy);
        SignerKey key = keyFile == null ? null : SignerKey.read(keyFile);
        try (ReplayReader replay = piped ? StandardFiles.openReplay(streams) : open(OutputFiles.path(file))) {
            if (verify) {
                return verify(replay, new VerifyReport(streams.out(), streams.outColour(), partial, keyFile, key,
                    require, quiet, new ViewComparison()));
            }
            if (replay.header() == null) {
                streams.warn(replay.warning());
                return ExitStatus.DONE;
            }
            if (map || impacts) {
                requireBodies(replay, map ? "--map" : "--impacts");
            }
            if (json) {
                printJson(replay);
                return ExitStatus.DONE;
            }
            if (map) {
                streams.out().print(TextMap.of(replay));
            } else if (frames) {
                FramePrinter.print(streams, replay,
                    PlayerChoice.of(player, replay.header().names(), replay.source()), turn, referee.types());
            } else if (turn != null && !impacts) {
                new TurnDetail(streams.out(), replay, referee.types()).print(turn);
            } else {
                int first = turn != null ? turn : from != null ? from : 0;
                int last = turn != null ? turn : to != null ? to : Integer.MAX_VALUE;
                if (impacts) {
                    ImpactList.print(streams, replay, first, last);
                } else {
                    new TurnTable(streams, replay).print(first, last, quiet);
                }
            }
            streams.warn(replay.warning());
            return ExitStatus.DONE;
        }
    }

    private void checkCall() {
        boolean range = from != null || to != null;
        check.that(turn == null || !range, "--turn and --from or --to exclude each other");
        check.that(from == null || from >= 0, "--from: found " + from + ", expected 0 or more");
        check.that(to == null || to >= (from == null ? 0 : from), "--to: found " + to + ", expected "
            + (from == null ? "0 or more" : "at least --from, which is " + from));
        check.that(turn == null || turn >= 1, "--turn: found " + turn + ", expected 1 or more");
        check.that(!verify || !frames && !impacts && !range && turn == null,
            "--verify takes the whole match, expected no --turn, --from, --to, --impacts or --frames with it");
        check.that(verify || !partial, "--partial is for --verify, expected both");
        check.that(verify || signedBy == null, "--signed-by is for --verify, expected both");
        check.that(require == null || verify && signedBy != null,
            "--require is for --verify with --signed-by, expected all three");
        check.that(!frames || !impacts && !range,
            "--frames prints the whole match or one --turn, expected no --from, --to or --impacts with it");
        check.that(!frames || player != null, "--frames: expected --player P with it");
        check.that(frames || player == null, "--player is for --frames, expected both");
        check.that(at == null || picture != null, "--at is for --picture, expected both");
        check.that(at == null || at >= 0 && at <= MOST_TURNS, "--at: found " + at + ", expected a number of turns");
        check.that(site == null || view != null && site.matches("https?://\\S{1,1000}"),
            "--site: expected --view with it, and an address that begins with http:// or https://");
        check.that(picture == null || !StandardFiles.is(picture) && !json && !map && (at == null || turn == null),
            "--picture: expected a file, no --json or --map, and only one of --turn and --at with it");
        check.that(picture == null || StandardFiles.is(picture) || moving()
            || picture.toLowerCase(Locale.ROOT).endsWith(".png"),
            "--picture: found " + picture + ", expected a name that ends in .png or .svg");
        check.that(picture == null || !verify && !frames && !impacts, "--picture: expected no --verify, --frames or "
            + "--impacts with it");
        check.that(!moving() || turn == null && at == null && view == null && !open && !quiet,
            "--picture: found " + picture + ", a moving picture, expected no --turn, --at, --view, --open or --quiet "
            + "with it");
        check.that(view == null && !open && picture == null
            || !verify && !frames && !impacts && (!range || moving())
            && (turn == null || picture != null && view == null && !open),
            "--view and --open take the whole match, expected no --verify, --frames, --impacts, --turn, --from or --to "
            + "with them");
        check.that(beside == null || (view != null || open) && !StandardFiles.is(view) && !StandardFiles.is(beside)
            && !StandardFiles.is(file) && picture == null && site == null, "--beside: expected --view with a file, or "
            + "--open, with it, two files of replays, and no --picture or --site");
        check.that(!viewer || !verify && !frames && !impacts && !range && turn == null && !json && !map && view == null
            && picture == null && !quiet, "--viewer takes the whole match, expected nothing else but --open with it");
        check.that(!open || !StandardFiles.is(view), "--open: found --view - with it, expected a file for the page");
        check.that(!map || !verify && !frames && !impacts && !range && turn == null && !json && view == null && !open,
            "--map draws the end of the match, expected nothing else with it");
        check.that(!overwrite || view != null || picture != null, "--overwrite: expected --view or --picture with it");
        check.that(!quiet || !frames && !impacts && turn == null, "--quiet is for the summary and --verify");
        check.that(!json || !frames && !quiet && !open && view == null && (impacts || from == null && to == null),
            "--json is for the summary, --turn, --impacts and --verify");
    }

    public static ReplayReader open(Path path) {
        try {
            return ReplayReader.open(path);
        } catch (IOException problem) {
            throw new InputException(path + (Files.exists(path) ? ": cannot be read: no permission"
                : ": found no such file, expected a replay"));
        }
    }

    /**
     * @param replay or {@code null} if it has been read
     * @param bytes  of it, or {@code null} if there is a file
     */
    private int view(Path replay, byte[] bytes) throws InterruptedException {
        PageFile page = PageFile.of(streams, replay, bytes, file, site, referee.types());
        if (StandardFiles.is(view)) {
            streams.out().writeBytes(page.html());
            return ExitStatus.DONE;
        }
        if (view != null || open) {
            Path path = page.write(view, overwrite);
            say("Page: " + path);
            String preview = page.preview(path, overwrite);
            if (preview != null) {
                say(preview);
            }
            if (open) {
                Pages.open(streams, path.toAbsolutePath().toUri());
            }
        }
        if (picture != null) {
            check.that(turn == null || turn <= page.turns(), "--turn: found " + turn + ", expected 1 to "
                + page.turns());
            check.that(at == null || at <= page.turns(), "--at: found " + at + ", expected 0 to " + page.turns());
            say("Picture: " + page.picture(picture, at != null ? at : turn != null ? turn : page.turns(), overwrite));
        }
        return ExitStatus.DONE;
    }

    private int viewBeside() throws InterruptedException {
        BesidePage both = new BesidePage(streams, OutputFiles.path(file), OutputFiles.path(beside));
        Path page = view == null ? Pages.unnamed() : OutputFiles.path(view);
        both.write(page, overwrite || view == null, referee.types());
        say("Page: " + page);
        say(both.summary());
        if (open) {
            Pages.open(streams, page.toAbsolutePath().toUri());
        }
        return ExitStatus.DONE;
    }

    private static void requireBodies(ReplayReader replay, String option) {
        Games.requireComputed(replay.header().game(), ReplayHeaderText.scene(replay.header()), option);
    }

    private boolean moving() {
        return picture != null && picture.toLowerCase(Locale.ROOT).endsWith(".svg");
    }

    private int movingPicture(boolean piped) {
        Path svg = OutputFiles.path(picture);
        try (ReplayReader replay = piped ? StandardFiles.openReplay(streams) : open(OutputFiles.path(file))) {
            if (replay.header() != null) {
                requireBodies(replay, "--picture");
                Pages.write(svg, MovingPicture.of(replay, from != null ? from : 0,
                    to != null ? to : Integer.MAX_VALUE).getBytes(StandardCharsets.UTF_8), overwrite);
                say("Picture: " + svg);
            } else {
                throw new InputException("--picture: found a replay that was cut off in its header");
            }
            streams.warn(replay.warning());
            return ExitStatus.DONE;
        }
    }

    private void say(String words) {
        if (!quiet) {
            streams.out().println(words);
            streams.out().flush();
        }
    }

    private void printJson(ReplayReader replay) {
        ReplayJson object = new ReplayJson(streams, replay);
        if (impacts) {
            object.impacts(turn != null ? turn : from != null ? from : 0,
                turn != null ? turn : to != null ? to : Integer.MAX_VALUE);
        } else if (turn != null) {
            object.turn(turn, referee.types());
        } else {
            object.summary();
        }
    }

    private int verify(ReplayReader replay, VerifyReport report) {
        Verification verification = Verification.of(replay, referee.types(), report.views());
        if (json) {
            return new ReplayJson(streams, replay).verification(verification, report);
        }
        streams.warn(verification.warning());
        return report.print(replay, verification);
    }
}
