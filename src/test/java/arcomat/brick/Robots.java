package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.RobotJar;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.source.SourceFile;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Jars for tests. */
public final class Robots {
    public static final BrickTable TABLE = BrickTable.leJos();

    private Robots() {}

    /** Classes written by hand, without their texts. */
    public static RobotJar jar(Map<String, byte[]> classes) {
        return jar(classes, List.of());
    }

    /** Classes written by hand; a class belongs to the text of its outermost class. */
    public static RobotJar jar(Map<String, byte[]> classes, List<SourceFile> texts) {
        return new RobotJar(
                "robot.jar",
                classes.entrySet().stream()
                        .map(entry -> robotClass(entry.getKey(), entry.getValue(), texts))
                        .toList());
    }

    public static BrickReport check(Map<String, byte[]> classes) {
        return BrickCheck.check(jar(classes), TABLE);
    }

    private static RobotClass robotClass(String name, byte[] bytes, List<SourceFile> texts) {
        String path = name.replaceFirst("\\$.*", "") + ".java";
        Optional<SourceFile> text = texts.stream().filter(t -> t.path().equals(path)).findFirst();
        return new RobotClass(name + ".class", bytes, Origin.HAND_WRITTEN, text);
    }
}
