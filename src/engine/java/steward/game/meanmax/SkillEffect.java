package steward.game.meanmax;

/**
 * Effect of a skill that was cast: a place, not a body, with an id from the same counter. When it is spent, a later
 * turn may reuse the object.
 */
public final class SkillEffect {

    private int id;
    private Skill skill;
    private double x;
    private double y;
    private int looter;
    private int duration;

    /**
     * Makes it this effect.
     *
     * @param turnsLeft that it still works
     * @param by        id of the looter that cast it
     */
    SkillEffect set(int newId, Skill newSkill, double newX, double newY, int turnsLeft, int by) {
        id = newId;
        skill = newSkill;
        x = newX;
        y = newY;
        duration = turnsLeft;
        looter = by;
        return this;
    }

    SkillEffect copy() {
        return new SkillEffect().set(id, skill, x, y, duration, looter);
    }

    void countDown() {
        duration--;
    }

    public int id() {
        return id;
    }

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
