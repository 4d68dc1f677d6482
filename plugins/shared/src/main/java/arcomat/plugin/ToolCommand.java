package arcomat.plugin;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What a step of a build says to the tool: a command with its options and models. Files are named
 * from the folder of the whole build, as the tool names them when it tells of them.
 *
 * @param words as on a command line
 */
public record ToolCommand(List<String> words) {
    public ToolCommand {
        words = List.copyOf(words);
    }

    public static ToolCommand of(String... words) {
        return new ToolCommand(List.of(words));
    }

    /**
     * Reports what is wrong with models.
     *
     * @param profile what they must fulfil
     * @param state the file in which the tool remembers what it found the last time
     * @param baseline the file with findings that are known, if there is one
     */
    public static ToolCommand check(
            String profile, String state, boolean warningsFail, Optional<String> baseline) {
        return of("check", "--profile", profile, "--state", state, "--verbose")
                .with("--strict", warningsFail)
                .with("--baseline", baseline);
    }

    /** Runs stream tests. */
    public static ToolCommand test() {
        return of("test");
    }

    /**
     * Proves what models say they keep.
     *
     * @param seconds after which to give up on a question, if ever
     */
    public static ToolCommand verify(Optional<Integer> seconds) {
        return of("verify").with("--timeout", seconds);
    }

    /**
     * Writes code.
     *
     * @param target of the tool, or a folder of templates
     * @param out the folder to write, which is replaced as a whole
     * @param choose who decides where a model leaves a choice
     * @param main the only component that gets a program; all if absent
     */
    public static ToolCommand generate(
            String target, String out, String choose, Optional<String> main) {
        return of("generate", "--target", target, "--out", out, "--choose", choose)
                .with("--main", main);
    }

    /** Looks whether the brick has and can hold what the jar of a robot needs. */
    public static ToolCommand checkBrick(String jar) {
        return of("check-brick", "--jar", jar);
    }

    /** The same with an option that has a value, if there is one. */
    public ToolCommand with(String option, Optional<?> value) {
        return value.map(it -> and(option, it.toString())).orElse(this);
    }

    /** The same with an option that is there or is not. */
    public ToolCommand with(String option, boolean there) {
        return there ? and(option) : this;
    }

    /** The same with an option as often as it has values. */
    public ToolCommand with(String option, Collection<String> values) {
        return and(values.stream().flatMap(each -> Stream.of(option, each)).toArray(String[]::new));
    }

    /**
     * The same with reports written to files.
     *
     * @param text the file for people
     * @param machines the format and the file for programs: {@code sarif=FILE}
     */
    public ToolCommand reporting(String text, String machines) {
        return with("--report", List.of("text=" + text, machines));
    }

    /**
     * The same about models.
     *
     * @param paths files, and model roots
     * @param libraries model roots of others, which the models may refer to
     */
    public ToolCommand about(Collection<String> paths, Collection<String> libraries) {
        return with("--library", libraries).and(paths.toArray(String[]::new));
    }

    private ToolCommand and(String... more) {
        List<String> all = new ArrayList<>(words);
        all.addAll(List.of(more));
        return new ToolCommand(all);
    }

    /** As somebody would type it. */
    @Override
    public String toString() {
        return "arcomat " + String.join(" ", words);
    }
}
