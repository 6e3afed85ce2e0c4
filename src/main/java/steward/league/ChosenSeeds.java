package steward.league;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import steward.contest.Contest.Entrant;
import steward.contest.seeds.SeedFile;
import steward.files.InputException;
import steward.files.OutputFiles;

/**
 * Copies of the seed lists that were played in a league and had been chosen by games of bots. The league keeps its own
 * copy, because its games stay when {@code league.json} names another list, or when the list belonged to one test.
 */
public final class ChosenSeeds {

    private static final String FOLDER = "chosen";

    private final List<SeedFile> lists;

    private ChosenSeeds(List<SeedFile> lists) {
        this.lists = List.copyOf(lists);
    }

    /** Keeps a list that is about to be played, unless nobody's games chose it. @param list {@code null} for none */
    public static void keep(LeagueFolder league, SeedFile list) {
        if (list == null || list.choosers().isEmpty()) {
            return;
        }
        Path folder = league.path().resolve(FOLDER);
        Path file = folder.resolve(new TextHash().add(list.text()).hex() + ".txt");
        try {
            if (!Files.exists(file)) {
                Files.createDirectories(folder);
                OutputFiles.replace(file, list.text().getBytes(StandardCharsets.UTF_8));
            }
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + OutputFiles.reason(file, problem));
        }
    }

    /** Reads the lists that were played, and that of the settings. */
    public static ChosenSeeds of(LeagueFolder league, LeagueSettings settings) {
        List<SeedFile> lists = new ArrayList<>();
        Path folder = league.path().resolve(FOLDER);
        try (Stream<Path> files = Files.isDirectory(folder) ? Files.list(folder) : Stream.empty()) {
            files.filter(file -> file.toString().endsWith(".txt")).sorted().map(SeedFile::read).forEach(lists::add);
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be read: " + OutputFiles.reason(folder, problem));
        }
        Stream.of(league.seeds(settings)).filter(Objects::nonNull).forEach(lists::add);
        return new ChosenSeeds(lists);
    }

    /** Names of those of some bots by whose games seeds of the lists were chosen, each once. */
    public List<String> choosers(List<Entrant> bots) {
        return bots.stream().filter(bot -> bot.problem() == null).filter(bot -> {
            String identity = BotIdentity.ofProgram(bot);
            return lists.stream().anyMatch(list -> list.choosers().containsKey(identity));
        }).map(Entrant::name).distinct().toList();
    }

    /** Returns the lists of them that games of some bots chose. */
    public ChosenSeeds by(List<Entrant> bots) {
        List<String> identities = bots.stream().map(BotIdentity::ofProgram).toList();
        return new ChosenSeeds(lists.stream().filter(list -> identities.stream()
            .anyMatch(list.choosers()::containsKey)).toList());
    }

    /** True if a seed stands in one of the lists. */
    public boolean has(long seed) {
        return lists.stream().anyMatch(list -> list.seeds().has(seed));
    }
}
