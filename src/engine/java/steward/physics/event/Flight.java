package steward.physics.event;

import steward.physics.Bodies;

/** Free flight of all bodies from one impact to the next and to the end of the turn. */
public abstract sealed class Flight permits Flight.Plain, ExactFlight {

    /** Begins a turn. @return its time, 0 */
    abstract double begin(Bodies bodies);

    /** Moves all bodies to the first impact of the batch that the queue has chosen. @return its time within the turn */
    abstract double toImpact(Bodies bodies, double now, ImpactQueue queue);

    /** Moves all bodies to the end of the turn. */
    abstract void toEnd(Bodies bodies, double now);

    /** In plain doubles. */
    static final class Plain extends Flight {

        @Override
        double begin(Bodies bodies) {
            return 0;
        }

        @Override
        double toImpact(Bodies bodies, double now, ImpactQueue queue) {
            double time = queue.time(0);
            EventAdvance.fly(bodies, time - now);
            return time;
        }

        @Override
        void toEnd(Bodies bodies, double now) {
            EventAdvance.fly(bodies, 1 - now);
        }
    }
}
