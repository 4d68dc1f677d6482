package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.docs.Session.Step;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Does what a page tells its reader to do, block by block, and compares. What a block is for stands
 * behind its opening fence:
 *
 * <ul>
 *   <li>{@code console}: commands and what they print. Those of Gradle are tried by the tests of
 *       the plugin.
 *   <li>{@code arc shop/Robot.arc}: a file to be written, whatever its language. A command behind
 *       it has to read it.
 *   <li>{@code java of shop/Robot.java}: lines of a file, one that commands made or else one of
 *       this project.
 *   <li>{@code yaml}, {@code shell}, {@code groovy Jenkinsfile}: lines for a build server or this
 *       project's build, in which commands, options and tasks are there.
 *   <li>{@code json}, {@code lua}, {@code toml}, {@code lisp}: lines for agents and editors, which
 *       are told to start a command that is there.
 *   <li>{@code xml}: lines for a build by Maven, which names the plugin.
 *   <li>{@code synopsis}: a command with the options that it has.
 *   <li>{@code files}: what is where in this project.
 * </ul>
 *
 * There are no other blocks.
 */
final class Replay {
    private static final Pattern COMMAND = Pattern.compile("\\barcomat ([a-z-]+ [^'\"]*)");
    private static final Pattern OPTION = Pattern.compile("(--[a-z-]+)");
    private static final Pattern FORMAT = Pattern.compile("--(?:format|report) ([a-z]+)");

    private final Terminal terminal;
    private final BuildTasks tasks;
    private final boolean mona;

    /** Files that no command has read yet, with the line of their block. */
    private final Map<String, Integer> unread = new LinkedHashMap<>();

    /** What the terminal shows instead of a block, where they differ. */
    private final Map<Fence, Session> news = new LinkedHashMap<>();

    private boolean hasBuild;

    /**
     * @param mona whether sessions with the program MONA can be tried here
     */
    Replay(Path directory, BuildTasks tasks, boolean mona) {
        this.terminal = new Terminal(directory);
        this.tasks = tasks;
        this.mona = mona;
    }

    Map<Fence, Session> run(List<Fence> fences) throws IOException {
        for (Fence fence : fences) {
            run(fence);
        }
        assertThat(unread).as("files that no command reads").isEmpty();
        return news;
    }

    private void run(Fence fence) throws IOException {
        String title = fence.title();
        if (fence.language().equals("console")) {
            if (mona || !title.equals("mona")) {
                replay(fence);
            }
        } else if (title.startsWith("of ")) {
            compare(fence, title.substring("of ".length()));
        } else if (fence.language().equals("groovy") && !title.equals("Jenkinsfile")) {
            assertThat(title).as(where(fence)).matches("(onto )?(build|settings)\\.gradle");
            unread.put(title, fence.line());
            hasBuild |= title.equals("build.gradle");
        } else if (!title.isEmpty() && !title.equals("Jenkinsfile")) {
            write(fence);
        } else {
            runPlain(fence);
        }
    }

    private void runPlain(Fence fence) throws IOException {
        switch (fence.language()) {
            case "yaml" -> {
                new YAMLMapper().readTree(fence.text());
                tryCommands(fence);
            }
            case "shell", "groovy" -> tryCommands(fence);
            case "synopsis" -> tryOptions(fence);
            case "files" -> fence.body().forEach(Replay::findFile);
            case "rooms" -> {
                // ArchitecturePageTest draws it.
            }
            // Settings of editors and agents: they are told to start a command that there is.
            case "lua", "toml", "lisp" ->
                    assertThat(fence.text()).as(where(fence)).contains("\"language-server\"");
            // Lines for a build by Maven, as the tests of the plugin have them.
            case "xml" ->
                    assertThat(fence.text()).as(where(fence)).contains("arcomat-maven-plugin");
            case "json" -> {
                new ObjectMapper().readTree(fence.text());
                assertThat(fence.text())
                        .as(where(fence))
                        .containsPattern("\"(mcp|language-server)\"");
            }
            default -> throw new AssertionError(where(fence) + ": nobody checks this block");
        }
    }

    private void write(Fence fence) throws IOException {
        Path file = terminal.directory().resolve(fence.title());
        Files.createDirectories(file.getParent());
        Files.writeString(file, fence.text());
        assertThat(unread.put(fence.title(), fence.line())).as(where(fence)).isNull();
    }

    private void compare(Fence fence, String name) throws IOException {
        Path made = terminal.directory().resolve(name);
        Path file = Files.exists(made) ? made : Path.of(name);
        String text = Files.readString(file);
        if (!new Lines(fence.text()).areIn(text)) {
            assertThat(text).as(where(fence)).contains(fence.text());
        }
    }

    private void replay(Fence fence) {
        List<Step> shown = Session.of(fence).steps();
        List<Step> actual = new ArrayList<>();
        for (Step step : shown) {
            noteFilesOf(step.command());
            actual.add(step.command().startsWith("gradle ") ? built(step) : replay(step));
        }
        if (!actual.equals(shown)) {
            news.put(fence, new Session(actual));
        }
    }

    /** The tests of the plugin do this, for pages with a build. */
    private Step built(Step step) {
        assertThat(hasBuild).as(step.command()).isTrue();
        return step;
    }

    /** The step itself if it shows what happens. */
    private Step replay(Step step) {
        String actual = terminal.run(step.command()).printed() + "\n";
        return new Lines(step.text()).describe(actual)
                ? step
                : new Step(step.command(), actual.lines().toList());
    }

    private void noteFilesOf(String command) {
        List<String> words = List.of(command.split("[ ']+"));
        unread.keySet().removeIf(file -> words.stream().anyMatch(word -> reads(word, file)));
        if (words.contains("generate")) {
            unread.keySet().removeIf(file -> file.startsWith("platform/"));
        }
        if (words.get(0).equals("gradle")) {
            unread.keySet().removeIf(file -> file.endsWith(".gradle"));
        }
    }

    private static boolean reads(String word, String file) {
        return Path.of(file).startsWith(Path.of(word.replaceAll("#.*", "")));
    }

    /** The commands in a text for others are those that the command line accepts. */
    private void tryCommands(Fence fence) {
        for (String line : fence.body()) {
            Matcher command = COMMAND.matcher(line);
            if (command.find()) {
                noteFilesOf(command.group());
                tryOptions(command.group(1), fence);
            } else if (line.contains("./gradlew ")) {
                tasks.find(line);
                noteFilesOf("gradle");
            }
        }
    }

    private void tryOptions(Fence fence) {
        fence.body().forEach(line -> tryOptions(line.substring("arcomat ".length()), fence));
    }

    /** The command is there, with the options and formats that are named. */
    private void tryOptions(String arguments, Fence fence) {
        String command = arguments.split(" ")[0];
        String help = terminal.arcomat(List.of(command, "--help")).printed();
        assertThat(help).as(where(fence)).startsWith("Usage: arcomat " + command + " ");
        for (Pattern named : List.of(OPTION, FORMAT)) {
            Matcher word = named.matcher(arguments);
            while (word.find()) {
                assertThat(help)
                        .as("%s: %s", where(fence), arguments)
                        .containsPattern("(?<=[ ])" + word.group(1) + "\\b");
            }
        }
    }

    private static void findFile(String line) {
        assertThat(Path.of(line.split(" ")[0])).exists();
    }

    private static String where(Fence fence) {
        return "block at line " + fence.line();
    }
}
