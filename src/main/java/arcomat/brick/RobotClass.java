package arcomat.brick;

import arcomat.source.SourceFile;

import java.util.Optional;

/**
 * A class of a robot's jar.
 *
 * @param path its entry in the jar, as {@code coffee/logic/Fetcher.class}
 * @param bytes the class file; not changed by anybody
 * @param text the Java text that it was compiled from, where it is at hand: findings then name
 *     lines of it
 */
public record RobotClass(String path, byte[] bytes, Origin origin, Optional<SourceFile> text) {}
