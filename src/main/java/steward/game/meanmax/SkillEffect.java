package steward.game.meanmax;

/** A skill that was cast: a place that is no body, with an id from the same counter. */
public final class SkillEffect {

    private final int id;
    private final Skill skill;
    private final double x;
    private final double y;
    private final int looter;
    private int duration;

    /**
     * @param duration turns that it still works
     * @param looter   id of the looter that cast it
     */
    SkillEffect(int id, Skill skill, double x, double y, int duration, int looter) {
        this.id = id;
        this.skill = skill;
        this.x = x;
        this.y = y;
        this.duration = duration;
        this.looter = looter;
    }

    SkillEffect copy() {
        return new SkillEffect(id, skill, x, y, duration, looter);
    }

    void countDown() {
        duration--;
    }

    /** Its id. */
    public int id() {
        return id;
    }

    /** Which skill it is. */
    public Skill skill() {
        return skill;
    }

    /** Its centre, in u. */
    public double x() {
        return x;
    }

    /** Its centre, in u. */
    public double y() {
        return y;
    }

    /** Turns that it still works. */
    public int duration() {
        return duration;
    }

    /** The id of the looter that cast it. */
    public int looter() {
        return looter;
    }
}
