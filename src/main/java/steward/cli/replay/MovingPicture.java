package steward.cli.replay;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import steward.cli.streams.Json;
import steward.files.InputException;
import steward.match.MatchResult;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.replay.page.PageTemplate;
import steward.text.TextFormat;

/**
 * Animated SVG picture of a match for a README or a course page: no script, ten turns a second, in a loop. Bodies move
 * straight from the end of a turn through each of their impacts to the end of the next. It draws from the game's own
 * description and knows no game.
 */
final class MovingPicture {

    private static final int TURNS_A_SECOND = 10;
    /** Turns for which the end is shown. */
    private static final int PAUSE = 15;
    private static final int WIDTH = 800;
    /** Parts of the picture's width to which places are rounded. */
    private static final double STEPS = 2000;
    /** Bodies times turns: a picture of some 3 MB. */
    private static final long MOST_PLACES = 200_000;
    private static final String GROUND = "#0d1420";
    private static final String LINES = "#8fa3bd";
    private static final String[] TEAMS = {"#4cc2ff", "#ffa53a", "#2fd6a3", "#f08cc8", "#f2e55c", "#9c8cff", "#b7ea84",
        "#d3875a"};

    private final double left;
    private final double top;
    private final double width;
    private final double height;
    private final Map<Integer, Track> tracks = new TreeMap<>();
    private final Map<String, Zone> zones = new LinkedHashMap<>();
    private final PictureScores scores;
    private boolean isCourse;
    private String headline;
    private int turns;
    private long places;

    /** A moment of a body, in turns since the first that is shown. */
    private record Knot(double time, double x, double y) { }

    /** A body over the turns. */
    private static final class Track {
        private final List<Knot> knots = new ArrayList<>();
        private final List<Double> radii = new ArrayList<>();
        private final List<Double> degrees = new ArrayList<>();
        private final List<Double> ends = new ArrayList<>();
        private double radius;
        private int owner = -1;
        private String label = "";
        private int first;
        private int last;
    }

    /** A zone that a game made while it went, with the turns at whose end it was there. */
    private record Zone(Map<?, ?> shape, List<Integer> turns) { }

    private MovingPicture(Map<?, ?> field, int players) {
        scores = new PictureScores(players);
        left = Json.number(field.get("x"));
        top = Json.number(field.get("y"));
        width = Json.number(field.get("width"));
        height = Json.number(field.get("height"));
    }

    /**
     * @param replay just opened, with a header; read to its end
     * @param from   the turn at whose end it begins; 0 is the start
     * @param to     the turn at whose end it stops
     * @throws InputException if so many bodies would be in it that hardly a browser could show it
     */
    static String of(ReplayReader replay, int from, int to) {
        Map<String, Object> drawing = Json.object(replay.drawing());
        if (!(drawing.get("field") instanceof Map<?, ?> field)) {
            throw new InputException(replay.source() + ", line 1: drawing: found no field, expected what to draw");
        }
        MovingPicture picture = new MovingPicture(field, replay.header().names().size());
        Map<Integer, Integer> owners = owners(drawing);
        int turn = 0;
        Map<String, Object> outcome = Json.object(replay.start());
        for (RecordedTurn next = replay.next(); turn <= to; next = replay.next()) {
            if (turn >= from) {
                picture.add(outcome, turn - from);
                picture.scores.add(outcome, owners);
            }
            if (picture.places > MOST_PLACES) {
                throw new InputException(replay.source() + ": found more than " + MOST_PLACES + " places of bodies in "
                    + "turns " + from + " to " + turn + ", expected fewer for a moving picture; --from and --to take "
                    + "a part");
            }
            if (next == null) {
                break;
            }
            outcome = Json.object(next.outcome());
            turn++;
        }
        if (turn < from) {
            throw new InputException("--from: found " + from + ", expected at most " + turn
                + ", the turns of the match");
        }
        List<String> names = IntStream.range(0, replay.header().names().size())
            .mapToObj(player -> ReplayHeaderText.name(replay.header(), player)).toList();
        MatchResult result = turn <= to ? RecordedResult.of(replay, names) : null;
        picture.headline = result == null ? null : headline(result);
        return picture.drawn(drawing, names);
    }

    private static Map<Integer, Integer> owners(Map<String, Object> drawing) {
        Map<Integer, Integer> owners = new TreeMap<>();
        for (Map<?, ?> body : Json.objects(drawing.get("bodies"))) {
            if (body.get("owner") instanceof Double owner) {
                owners.put((int) Json.number(body.get("id")), owner.intValue());
            }
        }
        return owners;
    }

    /** Who won, in a few words. */
    static String headline(MatchResult result) {
        return TextFormat.plain(result.players().size() < 2 ? result.ending() : result.winner() < 0 ? "Draw"
            : result.players().get(result.winner()).name() + " wins");
    }

    private void add(Map<String, Object> outcome, int turn) {
        if (turn > 0) {
            for (Map<?, ?> impact : Json.objects(outcome.get("impacts"))) {
                double time = turn - 1 + Json.number(impact.get("time"));
                knot(impact, "a", time);
                knot(impact, "b", time);
            }
            for (Map<?, ?> path : Json.objects(outcome.get("paths"))) {
                for (Object knot : (List<?>) path.get("knots")) {
                    List<?> values = (List<?>) knot;
                    knot((int) Json.number(path.get("id")), turn - 1 + Json.number(values.get(0)),
                        Json.number(values.get(1)), Json.number(values.get(2)));
                }
            }
        }
        if (!(outcome.get("state") instanceof Map<?, ?> state)) {
            return;                                    // one of those that a long replay leaves out
        }
        turns = turn;
        for (Map<?, ?> body : Json.objects(state.get("bodies"))) {
            Track track = tracks.computeIfAbsent((int) Json.number(body.get("id")), id -> new Track());
            if (track.radii.isEmpty()) {
                track.first = turn;
            }
            track.last = turn;
            isCourse |= PictureScores.isOnCourse(body);
            places++;
            track.owner = body.get("player") instanceof Double player ? player.intValue() : track.owner;
            track.knots.add(new Knot(turn, Json.number(body.get("x")), Json.number(body.get("y"))));
            track.ends.add((double) turn);
            track.radii.add(body.get("radius") instanceof Double radius ? radius : Double.NaN);
            double before = track.degrees.isEmpty() ? 0 : track.degrees.get(track.degrees.size() - 1);
            track.degrees.add(body.get("heading") instanceof Double heading
                ? before + Math.IEEEremainder(Math.toDegrees(heading) - before, 360) : before);
        }
        for (Map<?, ?> zone : Json.objects(outcome.get("zones"))) {
            zones.computeIfAbsent(zone.toString(), key -> new Zone(zone, new ArrayList<>())).turns.add(turn);
        }
    }

    private void knot(Map<?, ?> impact, String which, double time) {
        if (impact.get(which) instanceof Double id) {
            knot(id.intValue(), time, Json.number(impact.get(which + "x")), Json.number(impact.get(which + "y")));
        }
    }

    /** A place within a turn. The recorded order of impacts is that of time, up to the last bits of a batch. */
    private void knot(int id, double time, double x, double y) {
        Track track = tracks.get(id);
        if (track != null && track.knots.get(track.knots.size() - 1).time <= time) {
            track.knots.add(new Knot(time, x, y));
        }
    }

    private String drawn(Map<String, Object> drawing, List<String> names) {
        StringBuilder svg = new StringBuilder();
        double line = width / 400;
        svg.append(String.format(Locale.ROOT, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
            + "viewBox=\"%s %s %s %s\" font-family=\"sans-serif\" font-size=\"%s\" text-anchor=\"middle\">%n", WIDTH,
            Math.round(WIDTH * height / width), number(left), number(top), number(width), number(height),
            number(width / 45)));
        svg.append("<title>").append(PageTemplate.escape(String.join(" - ", names))).append("</title>\n");
        svg.append(gradients(names.size()));
        svg.append("<rect x=\"").append(number(left)).append("\" y=\"").append(number(top)).append("\" width=\"100%\" ")
            .append("height=\"100%\" fill=\"").append(GROUND).append("\"/>\n<g fill=\"none\" stroke=\"").append(LINES)
            .append("\" stroke-width=\"").append(number(line)).append("\">\n");
        if (isCourse) {
            svg.append(course(Json.objects(drawing.get("zones"))));
        }
        Json.objects(drawing.get("walls")).forEach(wall -> svg.append(wall(wall)));
        Json.objects(drawing.get("zones")).forEach(zone -> svg.append(circle(zone)).append("/>\n"));
        zones.values().forEach(zone -> svg.append(circle(zone.shape)).append(">")
            .append(shown(zone.turns.get(0), zone.turns.get(zone.turns.size() - 1))).append("</circle>\n"));
        svg.append("</g>\n<g fill=\"").append(LINES).append("\">\n");
        Json.objects(drawing.get("zones")).forEach(zone -> svg.append(label(zone)));
        for (Map<?, ?> body : Json.objects(drawing.get("bodies"))) {
            Track track = tracks.get((int) Json.number(body.get("id")));
            if (track != null) {
                track.radius = Json.number(body.get("radius"));
                track.label = Json.word(body.get("label"), 0);
                track.owner = body.get("owner") instanceof Double owner ? owner.intValue() : track.owner;
            } else if (body.containsKey("x")) {
                svg.append(circle(body)).append("/>\n");
            }
        }
        tracks.values().forEach(track -> svg.append(body(track)));
        svg.append("</g>\n<g text-anchor=\"start\">\n");
        for (int player = 0; player < names.size(); player++) {
            for (PictureScores.Span span : scores.spans(player)) {
                svg.append("<text x=\"").append(number(left + width / 60)).append("\" y=\"")
                    .append(number(top + width / 35 * (player + 1))).append("\" fill=\"").append(colour(player))
                    .append("\">").append(PageTemplate.escape(names.get(player) + span.words()))
                    .append(shown(span.first(), Math.min(span.last(), turns))).append("</text>\n");
            }
        }
        if (headline != null) {
            svg.append("<text text-anchor=\"middle\" font-size=\"").append(number(width / 22)).append("\" x=\"")
                .append(number(left + width / 2)).append("\" y=\"").append(number(top + height / 2))
                .append("\" fill=\"#fff\" stroke=\"").append(GROUND).append("\" paint-order=\"stroke\" stroke-width=\"")
                .append(number(width / 130)).append("\">").append(PageTemplate.escape(headline))
                .append("<animate attributeName=\"visibility\" calcMode=\"discrete\"").append(duration())
                .append(" keyTimes=\"0;").append(part(turns)).append("\" values=\"hidden;visible\"/></text>\n");
        }
        return svg.append("</g>\n</svg>\n").toString();
    }

    /** Light from the upper left on the bodies of each player. */
    private static String gradients(int players) {
        StringBuilder defs = new StringBuilder("<defs>");
        for (int k = 0; k < Math.min(players, TEAMS.length); k++) {
            defs.append("<radialGradient id=\"team").append(k).append("\" cx=\"0.35\" cy=\"0.3\" r=\"0.8\">")
                .append("<stop offset=\"0\" stop-color=\"#fff\"/><stop offset=\"0.35\" stop-color=\"").append(TEAMS[k])
                .append("\"/><stop offset=\"1\" stop-color=\"#14233a\"/></radialGradient>");
        }
        return defs.append("</defs>\n").toString();
    }

    /** The lane through the zones of a course, a curve as on the page: wide and faint, then a dashed line. */
    private String course(List<Map<?, ?>> zones) {
        int count = zones.size();
        if (count < 2) {
            return "";
        }
        StringBuilder lane = new StringBuilder("M").append(place(zones.get(0), null, null));
        for (int k = 0; k < count; k++) {
            Map<?, ?> from = zones.get(k);
            Map<?, ?> to = zones.get((k + 1) % count);
            lane.append('C').append(place(from, to, zones.get((k + count - 1) % count))).append(' ')
                .append(place(to, from, zones.get((k + 2) % count))).append(' ').append(place(to, null, null));
        }
        double radius = Json.number(zones.get(0).get("radius"));
        return "<g stroke=\"#5b86c8\"><path id=\"lane\" stroke-opacity=\"0.16\" stroke-width=\"" + number(2.2 * radius)
            + "\" d=\"" + lane + "Z\"/><path stroke-opacity=\"0.5\" stroke-dasharray=\"" + number(width / 80)
            + "\" d=\"" + lane + "Z\"/></g>\n";
    }

    /** The place of a zone, or a seventh of the way between two others beside it: a control point of the curve. */
    private String place(Map<?, ?> zone, Map<?, ?> to, Map<?, ?> from) {
        double x = to == null ? 0 : (Json.number(to.get("x")) - Json.number(from.get("x"))) / 7;
        double y = to == null ? 0 : (Json.number(to.get("y")) - Json.number(from.get("y"))) / 7;
        return number(Json.number(zone.get("x")) + x) + "," + number(Json.number(zone.get("y")) + y);
    }

    /** A ship that looks along the x axis. */
    private String hull(double r) {
        return "M" + number(r) + ",0L" + number(-0.75 * r) + "," + number(0.7 * r) + "L" + number(-0.4 * r) + ",0L"
            + number(-0.75 * r) + "," + number(-0.7 * r) + "Z";
    }

    private String wall(Map<?, ?> wall) {
        if (wall.containsKey("ax")) {
            return line(Json.number(wall.get("ax")), Json.number(wall.get("ay")), Json.number(wall.get("bx")),
                Json.number(wall.get("by")));
        }
        if (wall.containsKey("radius")) {
            return circle(wall) + "/>\n";
        }
        double x = Json.number(wall.get("x"));
        double y = Json.number(wall.get("y"));
        double alongX = -Json.number(wall.get("insideY")) * (width + height);
        double alongY = Json.number(wall.get("insideX")) * (width + height);
        return line(x - alongX, y - alongY, x + alongX, y + alongY);
    }

    private String line(double ax, double ay, double bx, double by) {
        return "<path d=\"M" + number(ax) + "," + number(ay) + "L" + number(bx) + "," + number(by) + "\"/>\n";
    }

    private String circle(Map<?, ?> round) {
        return "<circle cx=\"" + number(Json.number(round.get("x"))) + "\" cy=\"" + number(Json.number(round.get("y")))
            + "\" r=\"" + number(Json.number(round.get("radius"))) + "\"";
    }

    /** In the middle of a small zone, at the upper edge of a large one. */
    private String label(Map<?, ?> zone) {
        double radius = Json.number(zone.get("radius"));
        double below = radius < width / 10 ? width / 130 : width / 35 - radius;
        return "<text x=\"" + number(Json.number(zone.get("x"))) + "\" y=\""
            + number(Json.number(zone.get("y")) + below) + "\">"
            + PageTemplate.escape(Json.word(zone.get("label"), 0)) + "</text>\n";
    }

    private String body(Track track) {
        double[] radii = track.radii.stream().mapToDouble(r -> Double.isNaN(r) ? track.radius : r).toArray();
        String colour = track.owner < 0 ? LINES : colour(track.owner);
        StringBuilder body = new StringBuilder("<g fill=\"").append(colour).append("\">")
            .append(shown(track.first, track.last));
        List<Double> times = track.knots.stream().map(Knot::time).toList();
        body.append(animation("animateTransform", "transform", "translate", times, track.knots.stream()
            .map(knot -> number(knot.x) + "," + number(knot.y)).toList()));
        String fill = track.owner < 0 ? "fill-opacity=\"0.45\""
            : "fill=\"url(#team" + track.owner % TEAMS.length + ")\"";
        boolean turning = track.degrees.stream().anyMatch(angle -> angle != 0);
        body.append("<circle ").append(turning ? "fill-opacity=\"0.15\"" : fill).append(" stroke=\"").append(colour)
            .append("\" stroke-width=\"").append(number(width / 500)).append("\" r=\"").append(number(radii[0]))
            .append("\">");
        if (IntStream.range(1, radii.length).anyMatch(k -> radii[k] != radii[0])) {
            body.append(animation("animate", "r", null, track.ends, IntStream.range(0, radii.length)
                .mapToObj(k -> number(radii[k])).toList()));
        }
        body.append("</circle>");
        double r = radii[0];
        if (turning) {
            body.append("<path ").append(fill).append(" d=\"").append(hull(r)).append("\">")
                .append(animation("animateTransform", "transform", "rotate", track.ends,
                    track.degrees.stream()
                    .map(angle -> Long.toString(Math.round(angle))).toList())).append("</path>");
        }
        if (!track.label.isEmpty() && track.owner >= 0) {
            body.append("<text y=\"").append(number(r + width / 50)).append("\">")
                .append(PageTemplate.escape(track.label)).append("</text>");
        }
        return body.append("</g>\n").toString();
    }

    /** Hides a thing before and after the turns at whose end it was there. */
    private String shown(int first, int last) {
        if (first == 0 && last == turns) {
            return "";
        }
        double end = last == turns ? turns + PAUSE : last + 0.5;
        String times = "0;" + part(first == 0 ? end : first - 0.5)
            + (first == 0 || last == turns ? "" : ";" + part(end));
        String values = first == 0 ? "visible;hidden" : "hidden;visible" + (last == turns ? "" : ";hidden");
        return "<animate attributeName=\"visibility\" calcMode=\"discrete\"" + duration() + " keyTimes=\"" + times
            + "\" values=\"" + values + "\"/>";
    }

    private String animation(String element, String attribute, String type, List<Double> times, List<String> values) {
        StringBuilder keys = new StringBuilder("0");
        StringBuilder places = new StringBuilder(values.get(0));
        for (int k = 0; k < values.size(); k++) {
            boolean needed = k == 0 || k == values.size() - 1 || !values.get(k).equals(values.get(k - 1))
                || !values.get(k).equals(values.get(k + 1));
            if (needed && times.get(k) > 0) {
                keys.append(';').append(part(times.get(k)));
                places.append(';').append(values.get(k));
            }
        }
        return "<" + element + " attributeName=\"" + attribute + "\"" + (type == null ? "" : " type=\"" + type + "\"")
            + duration() + " keyTimes=\"" + keys + ";1\" values=\"" + places + ";" + values.get(values.size() - 1)
            + "\"/>";
    }

    private String duration() {
        return " dur=\"" + decimal((double) (turns + PAUSE) / TURNS_A_SECOND, 1) + "s\" repeatCount=\"indefinite\"";
    }

    private String part(double time) {
        return decimal(time / (turns + PAUSE), 5);
    }

    /** A length in units of the scene, to the step that can be seen. */
    private String number(double value) {
        return decimal(value, Math.max(0, (int) Math.ceil(-Math.log10(width / STEPS))));
    }

    private static String decimal(double value, int digits) {
        String text = String.format(Locale.ROOT, "%." + digits + "f", value);
        return text.contains(".") ? text.replaceAll("0+$", "").replaceAll("\\.$", "") : text;
    }

    private static String colour(int player) {
        return TEAMS[player % TEAMS.length];
    }
}
