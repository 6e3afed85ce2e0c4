package steward.cli.play;

import steward.report.Table;

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

    /** Columns of the table, and their units; none for a count. */
    static final Table<TurnRow> COLUMNS = new Table<TurnRow>().value("turn", TurnRow::turn)
        .value("energy [m u^2/turn^2]", TurnRow::energy).value("momentumX [m u/turn]", TurnRow::momentumX)
        .value("momentumY [m u/turn]", TurnRow::momentumY).value("impacts", TurnRow::impacts)
        .value("potential [m u^2/turn^2]", TurnRow::potential).value("limitTime [turn]", TurnRow::limitTime)
        .value("rest [m u^2/turn^2]", TurnRow::rest).value("restSum [m u^2/turn^2]", TurnRow::restSum)
        .value("angularMomentum [m u^2/turn]", TurnRow::angularMomentum)
        .value("temperature [m u^2/turn^2]", TurnRow::temperature)
        .value("pressureWalls [m/turn^2]", TurnRow::pressureWalls)
        .value("pressureVirial [m/turn^2]", TurnRow::pressureVirial);

    boolean isLimited() {
        return !Double.isNaN(limitTime);
    }
}
