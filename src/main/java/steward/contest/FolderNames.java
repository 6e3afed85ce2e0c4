package steward.contest;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.command.BotCommand;
import steward.contest.Contest.Entrant;

/**
 * Names for bots whose programs have the same file name in different folders: {@code v1-bot.py} and {@code v2-bot.py}.
 */
final class FolderNames {

    private FolderNames() { }

    /** The names of bots, in their order; of programs in one folder they may still be equal. */
    static List<String> of(List<Entrant> entrants) {
        List<String> names = new ArrayList<>(entrants.stream().map(Entrant::name).toList());
        for (String name : names.stream().distinct().toList()) {
            List<Integer> alike = new ArrayList<>();
            List<Path> files = new ArrayList<>();
            for (int k = 0; k < names.size(); k++) {
                Path file = names.get(k).equals(name) ? file(entrants.get(k)) : null;
                if (file != null) {
                    alike.add(k);
                    files.add(file);
                }
            }
            List<String> folders = folders(files);
            for (int k = 0; k < folders.size(); k++) {
                names.set(alike.get(k), folders.get(k) + "-" + name);
            }
        }
        return names;
    }

    /** The file that gave a bot its name, absolute; {@code null} where it has a name of its own. */
    private static Path file(Entrant entrant) {
        if (entrant.problem() != null) {
            return null;
        }
        BotCommand command = BotCommand.parse(entrant.bot());
        return command.name() != null || command.prefix() == BotCommand.Prefix.BUILTIN ? null
            : entrant.program().folder().resolve(command.nameGiver(entrant.program().folder())).normalize();
    }

    /** The names of the nearest folders that are not all alike; none if all folders are. */
    private static List<String> folders(List<Path> files) {
        List<Path> folders = new ArrayList<>(files.stream().map(Path::getParent).toList());
        while (files.size() > 1 && folders.stream().allMatch(each -> each != null && each.getFileName() != null)) {
            List<String> names = folders.stream().map(folder -> folder.getFileName().toString()
                .replaceAll("[^\\p{L}\\p{M}\\p{N}._-]+", "-")).toList();
            if (names.stream().distinct().count() > 1) {
                return names;
            }
            folders.replaceAll(Path::getParent);
        }
        return List.of();
    }
}
