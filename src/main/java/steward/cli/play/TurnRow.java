package steward.cli.play;

import steward.json.JsonNumbers;
import tools.jackson.core.JsonGenerator;

/**
 * Sums over all bodies of finite mass at the end of a turn, such as energy and momentum, and over the turn's impacts.
 * Masses in m, lengths in u, times in turns. NaN stands for a sum that the scene or turn does not have.
 *
 * @param energy          kinetic energy; with forces a, of the speed v + a/2
 * @param momentumX       to the right
 * @param momentumY       downwards
 * @param impacts         their number in the turn
 * @param potential       minus what the forces gave the bodies that are left, since the start
 * @param limitTime       when the turn reached the bound on impacts
 * @param rest            energy that rest took in the turn
 * @param restSum         its sum since the start
 * @param angularMomentum about the origin, from x to y
 * @param temperature     energy of a body, on average: two degrees of freedom, and a Boltzmann constant of 1
 * @param pressureWalls   impulses on walls and bumpers in the turn, by their length
 * @param pressureVirial  energy and half of each impulse times the distance of the centres, or at a wall the radius, by
 *                        the area; where no force acts
 */
record TurnRow(int turn, double energy, double momentumX, double momentumY, int impacts, double potential,
               double limitTime, double rest, double restSum, double angularMomentum, double temperature,
               double pressureWalls, double pressureVirial) {

    /** The first line of the table, with units. */
    static final String COLUMNS = "turn,energy [m u^2/turn^2],momentumX [m u/turn],momentumY [m u/turn],impacts,"
        + "potential [m u^2/turn^2],limitTime [turn],rest [m u^2/turn^2],restSum [m u^2/turn^2],"
        + "angularMomentum [m u^2/turn],temperature [m u^2/turn^2],pressureWalls [m/turn^2],pressureVirial [m/turn^2]";

    boolean isLimited() {
        return !Double.isNaN(limitTime);
    }

    String line() {
        return turn + RunTables.cells(energy, momentumX, momentumY) + "," + impacts + RunTables.cells(potential,
            limitTime, rest, restSum, angularMomentum, temperature, pressureWalls, pressureVirial) + "\n";
    }

    void write(JsonGenerator out) {
        out.writeNumberProperty("turn", turn);
        JsonNumbers.writeOrNull(out, "energy", energy);
        JsonNumbers.writeOrNull(out, "momentumX", momentumX);
        JsonNumbers.writeOrNull(out, "momentumY", momentumY);
        out.writeNumberProperty("impacts", impacts);
        JsonNumbers.writeOrNull(out, "potential", potential);
        JsonNumbers.writeOrNull(out, "limitTime", limitTime);
        JsonNumbers.writeOrNull(out, "rest", rest);
        JsonNumbers.writeOrNull(out, "restSum", restSum);
        JsonNumbers.writeOrNull(out, "angularMomentum", angularMomentum);
        JsonNumbers.writeOrNull(out, "temperature", temperature);
        JsonNumbers.writeOrNull(out, "pressureWalls", pressureWalls);
        JsonNumbers.writeOrNull(out, "pressureVirial", pressureVirial);
    }
}
