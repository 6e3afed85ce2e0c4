package steward.cli.replay;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import steward.cli.shared.FailedException;
import steward.cli.shared.Pages;
import steward.cli.streams.StandardFiles;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameTypes;
import steward.live.PagePicture;
import steward.match.MatchResult;
import steward.replay.ReplayReader;
import steward.replay.page.PageExtras;
import steward.replay.page.ReplayPage;

/**
 * Page of a recorded match, and the files that are written from it.
 *
 * @param replay or {@code null} if it came on the standard input
 * @param turns  how many turns the match has
 * @param site   address for previews of links, which expect a picture beside it; or {@code null}
 */
record PageFile(Path replay, byte[] html, int turns, String site) {

    /**
     * Makes the page; a replay that was cut off is told to the user.
     *
     * @param replay or {@code null} if it has been read
     * @param bytes  of it, or {@code null} if there is a file
     * @param name   as the user wrote it
     * @param site   address for previews of links, or {@code null}
     */
    static PageFile of(Streams streams, Path replay, byte[] bytes, String name, String site, GameTypes types) {
        String title = replay == null || replay.getFileName() == null ? name : replay.getFileName().toString();
        String description = title;
        String warning;
        int turns = 0;
        try (ReplayReader reader = replay == null ? StandardFiles.openReplay(bytes) : ReplayCommand.open(replay)) {
            if (reader.header() != null) {
                title = Pages.title(reader.header().names());
                description = title + ": " + reader.header().game();
            }
            while (reader.next() != null) {
                turns++;
            }
            warning = reader.warning();
            MatchResult result = reader.header() == null ? null : RecordedResult.of(reader, reader.header().names());
            if (result != null) {
                description += ", " + MovingPicture.headline(result);
            }
        }
        byte[] whole = replay == null ? bytes : Pages.read(replay);
        String source = replay == null ? StandardFiles.INPUT : replay.toString();
        PageExtras extras = new PageExtras(types, site, description + ", " + turns + " turns");
        byte[] html = ReplayPage.of(whole, source, title, extras);
        streams.warn(warning);
        return new PageFile(replay, html, turns, site);
    }

    /** Writes the page to a file, or to one without a name if {@code null}, and returns where it is. */
    Path write(String view, boolean overwrite) {
        Path page = view == null ? Pages.unnamed() : OutputFiles.path(view);
        if (OutputFiles.isSame(page, replay)) {
            throw new InputException("--view: found the replay itself, expected another file");
        }
        Pages.write(page, html, overwrite || view == null);
        return page;
    }

    /**
     * Takes the picture that previews of links to the page show, of the end of the match.
     *
     * @return what to tell: where it is, or why it is missing; {@code null} where the page is for no address
     */
    String preview(Path page, boolean overwrite) throws InterruptedException {
        if (site == null) {
            return null;
        }
        String address = PageExtras.picture(site);
        Path png = page.resolveSibling(address.substring(address.lastIndexOf('/') + 1));
        if (Files.exists(png) && !overwrite) {
            return "Picture of previews: " + png + ", as it was; --overwrite would replace it";
        }
        try {
            PagePicture.take(page, turns, png);
            return "Picture of previews: " + png;
        } catch (IOException problem) {
            return "Picture of previews: " + png + " is missing: " + problem.getMessage();
        }
    }

    /** Takes a picture of a moment and returns where it is. */
    Path picture(String picture, double time, boolean overwrite) throws InterruptedException {
        Path png = OutputFiles.path(picture);
        if (OutputFiles.isSame(png, replay)) {
            throw new InputException("--picture: found the replay itself, expected another file");
        }
        if (Files.exists(png) && !overwrite) {
            throw new InputException(png + ": exists already, and is kept; --overwrite would replace it");
        }
        Path page = write(null, true);
        try {
            PagePicture.take(page, time, png);
        } catch (IOException problem) {
            throw new FailedException("--picture: " + png + ": " + problem.getMessage());
        } finally {
            page.toFile().delete();
        }
        return png;
    }
}
