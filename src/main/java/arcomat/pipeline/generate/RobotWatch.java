package arcomat.pipeline.generate;

import arcomat.generate.monitor.SelfWatch;

/**
 * What a robot watches itself for.
 *
 * @param robot qualified name of the component that its program runs
 * @param part path of the part that is watched; empty for the robot itself
 * @param requirement its name and line
 * @param goesOn whether the robot goes on after a violation
 */
public record RobotWatch(String robot, String part, String requirement, boolean goesOn) {
    static RobotWatch of(SelfWatch watch) {
        int line = watch.automaton().span().startPosition().line();
        return new RobotWatch(
                watch.program().qualifiedName(),
                watch.part(),
                watch.required().title(watch.automaton()) + " (line " + line + ")",
                watch.goesOn());
    }
}
