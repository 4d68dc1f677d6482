package arcomat.world;

import arcomat.world.Words.Unreadable;
import arcomat.world.World.Cup;
import arcomat.world.World.Robot;
import arcomat.world.arithmetic.Circle;

import java.util.ArrayList;
import java.util.List;

/**
 * A robot while its world is read: the kind may be described further below.
 *
 * @param name of its brick
 * @param place the name as it is written
 */
record RobotDraft(String name, Word place, Word kind, Pose pose, Cup cup) {
    private static final int MOST = 100;
    private static final int LONGEST_NAME = 16;

    /** Reads what follows {@code robot}. */
    static Row one(Words words) throws Unreadable {
        Word name = words.name("the name of a robot");
        Word kind = words.name("the name of a kind");
        return new Row(kind, List.of(standing(name, kind, words)));
    }

    /** Reads what follows {@code robots}: robots in a row, each so far from the one before. */
    static Row several(Words words) throws Unreadable {
        int count = words.count("how many robots", 0, MOST);
        Word name = words.name("the name of a robot");
        Word kind = words.name("the name of a kind");
        RobotDraft first = standing(name, kind, words);
        words.expect("step");
        Point step = words.point();
        String last = name.text() + count;
        if (last.length() > LONGEST_NAME) {
            throw Words.broken(
                    name,
                    "'%s' is too long for the name of a brick: up to %d"
                            .formatted(last, LONGEST_NAME));
        }
        List<RobotDraft> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            all.add(first.next(i, step));
        }
        return new Row(kind, all);
    }

    /** Robots of one line; there may be none. */
    record Row(Word kind, List<RobotDraft> robots) {}

    private static RobotDraft standing(Word name, Word kind, Words words) throws Unreadable {
        words.expect("at");
        Point place = words.point();
        double heading = words.take("heading") ? words.number("degrees", -360, 360) : 0;
        Pose pose = new Pose(place.x(), place.y(), Circle.radians(heading));
        return new RobotDraft(name.text(), name, kind, pose, cup(words));
    }

    private static Cup cup(Words words) throws Unreadable {
        if (!words.take("with")) {
            return Cup.NONE;
        }
        Word carried = words.choice("what it carries", List.of("cup", "coffee"));
        return carried.text().equals("cup") ? Cup.EMPTY : Cup.FULL;
    }

    private RobotDraft next(int steps, Point step) {
        Pose there =
                new Pose(pose.x() + steps * step.x(), pose.y() + steps * step.y(), pose.heading());
        return new RobotDraft(name + (steps + 1), place, kind, there, cup);
    }

    Robot of(Kind built) {
        return new Robot(name, built, pose, cup, place.place());
    }
}
