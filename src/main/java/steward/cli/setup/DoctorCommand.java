package steward.cli.setup;

import java.io.PrintStream;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import steward.cli.options.ProgramCommand;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Colour;
import steward.cli.streams.Json;
import steward.report.Fields;
import steward.text.TextFormat;

/** {@code steward doctor}: reports what works on this machine. */
@Command(name = "doctor", description = "Prints what works on this machine and what does not, and why: Java, the "
    + "isolation of bots, compilers and interpreters, the browser, the temporary folder.",
    footer = {"", "--json: works, and items (about, name, works, detail).",
        "", "Example:", "  steward doctor", "", "Exit status: 0, whatever was found."})
public final class DoctorCommand extends ProgramCommand {

    private static final int NAME = 20;
    private static final int WIDTH = 80;
    private static final String INDENT = " ".repeat(2 + 5 + NAME);

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Override
    public Integer call() throws InterruptedException {
        List<Checkup.Item> items = Checkup.all();
        if (json) {
            Json.print(streams, Fields.of("works", items.stream().allMatch(Checkup.Item::works),
                "items", Fields.each(items, item -> Fields.of("about", item.about(), "name", item.name(),
                    "works", item.works(), "detail", item.detail()))));
            return ExitStatus.DONE;
        }
        PrintStream out = streams.out();
        Colour colour = streams.outColour();
        String about = "";
        for (Checkup.Item item : items) {
            if (!item.about().equals(about)) {
                about = item.about();
                out.println(about);
            }
            String word = TextFormat.left(item.works() ? "yes" : "no", 5);
            String detail = TextFormat.wrap(item.detail(), " ", WIDTH - INDENT.length(), "").replace("\n",
                "\n" + INDENT);
            out.println("  " + (item.works() ? colour.good(word) : colour.warning(word))
                + TextFormat.left(item.name(), NAME) + detail);
        }
        return ExitStatus.DONE;
    }
}
