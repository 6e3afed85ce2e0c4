package steward.physics.event;

import steward.physics.Bodies;

/** How the bodies fly from one impact to the next and to the end of the turn. */
public abstract sealed class Flight permits Flight.Plain, ExactFlight {

    /** A turn begins. @return its time, 0 */
    abstract double begin(Bodies bodies);

    /** Everybody flies to the first impact that the queue has chosen. @return its time within the turn */
    abstract double toImpact(Bodies bodies, double now, ImpactQueue queue);

    /** Everybody flies to the end of the turn. */
    abstract void toEnd(Bodies bodies, double now);

    /** In doubles. */
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
