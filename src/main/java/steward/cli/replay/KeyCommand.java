package steward.cli.replay;

import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.files.OutputFiles;
import steward.replay.sign.SignerKey;
import steward.replay.sign.SigningKey;
import steward.text.NearestName;

/** {@code steward key}: makes and shows the keys with which replays are signed. */
@Command(name = "key", description = "Makes or shows a key for signing replays.",
    footer = {
        "", "new   writes a private key to FILE, which you keep secret, and its public key to",
        "      FILE.pub, which you give away. It prints the fingerprint by which people",
        "      recognise your key. An existing file is never replaced.",
        "show  prints the fingerprint of a public or a private key.",
        "", "The keys are Ed25519, in PEM: PKCS#8 and X.509. Whoever has FILE can sign in",
        "your name; without it nobody can.",
        "", "Examples:",
        "  steward key new mine.key",
        "  steward match --bot ./a --bot ./b --out m.jsonl --sign mine.key",
        "  steward replay m.jsonl --verify --signed-by mine.key.pub",
        "  steward key show mine.key.pub",
        "", "Exit status: 0 done; 2 wrong file or call."})
public final class KeyCommand extends ProgramCommand {

    @Spec
    private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "new|show", completionCandidates = Actions.class, description = "What to do.")
    private String what;

    @Parameters(index = "1", paramLabel = "FILE", description = "The file of the key.")
    private String file;

    /** Actions of the command. */
    static final class Actions implements Iterable<String> {

        @Override
        public Iterator<String> iterator() {
            return List.of("new", "show").iterator();
        }
    }

    @Override
    public Integer call() {
        Path path = OutputFiles.path(file);
        switch (what) {
            case "new" -> {
                SigningKey key = SigningKey.generate();
                key.write(path);
                streams.out().println("Private key: " + path);
                streams.out().println("Public key:  " + SigningKey.publicFile(path));
                streams.out().println("Fingerprint: " + key.publicKey().fingerprint());
            }
            case "show" -> streams.out().println((SigningKey.isPrivate(path) ? SigningKey.read(path).publicKey()
                : SignerKey.read(path)).fingerprint());
            default -> throw new ParameterException(spec.commandLine(), "new|show: found '" + what
                + "', expected new or show" + NearestName.question(what, List.of("new", "show"), "'"));
        }
        return ExitStatus.DONE;
    }
}
