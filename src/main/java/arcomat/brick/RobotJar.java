package arcomat.brick;

import java.util.List;

/**
 * All classes that a robot brings along, leJOS' own excepted.
 *
 * @param path the jar's path as it is shown
 */
public record RobotJar(String path, List<RobotClass> classes) {
    public RobotJar {
        classes = List.copyOf(classes);
    }
}
