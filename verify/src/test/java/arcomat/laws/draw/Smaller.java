package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** All models that are a little smaller than given ones; many of them break a condition. */
public final class Smaller {
    private static final Pattern STATE = Pattern.compile("\\bs([1-9]\\d*)\\b");
    private static final Pattern BEHAVIOUR = Pattern.compile(" (?:automaton|table)\\b");
    private static final Pattern PORT = Pattern.compile("    port .*?(\\w+);");
    private static final Pattern BLOCK_ITEM = Pattern.compile("(?<=[{,] ?)[^{},]+(?:, )?");
    private static final Pattern STEREOTYPE = Pattern.compile("<<[^>]*>> ");
    private static final Pattern CALCULATION = Pattern.compile("\\w+ [-+/] \\w+");
    private static final Pattern ALTERNATIVES = Pattern.compile("alt \\{(\\w+), \\w+\\}");

    private final List<SourceFile> files;
    private final List<List<SourceFile>> found = new ArrayList<>();

    private Smaller(List<SourceFile> files) {
        this.files = files;
    }

    /** The largest steps first. */
    public static List<List<SourceFile>> than(List<SourceFile> files) {
        Smaller smaller = new Smaller(files);
        smaller.each(smaller::withoutFile);
        smaller.each(smaller::withoutAutomaton);
        smaller.each(smaller::withoutPort);
        smaller.each(smaller::withoutLine);
        smaller.each(smaller::withoutState);
        smaller.each(i -> smaller.rewritten(i, Edits.GUARD, m -> ""));
        smaller.each(i -> smaller.rewritten(i, BLOCK_ITEM, m -> ""));
        smaller.each(i -> smaller.rewritten(i, STEREOTYPE, m -> ""));
        smaller.each(i -> smaller.rewritten(i, ALTERNATIVES, m -> m.group(1)));
        smaller.each(i -> smaller.rewritten(i, CALCULATION, m -> m.group().split(" ")[0]));
        smaller.each(i -> smaller.rewritten(i, Pattern.compile("\\b[lm]\\b"), m -> "k"));
        smaller.each(i -> smaller.rewritten(i, Pattern.compile("(?<= )[12]\\b"), m -> "0"));
        return smaller.found;
    }

    private void each(Consumer<Integer> file) {
        for (int i = 0; i < files.size(); i++) {
            file.accept(i);
        }
    }

    private void withoutFile(int file) {
        List<SourceFile> fewer = new ArrayList<>(files);
        fewer.remove(file);
        found.add(fewer);
    }

    private List<String> lines(int file) {
        return new ArrayList<>(files.get(file).text().lines().toList());
    }

    private void add(int file, List<String> lines) {
        List<SourceFile> changed = new ArrayList<>(files);
        String text = String.join("\n", lines) + "\n";
        changed.set(file, new SourceFile(files.get(file).path(), text));
        found.add(changed);
    }

    private void withoutAutomaton(int file) {
        List<String> lines = lines(file);
        for (int start = 0; start < lines.size(); start++) {
            if (BEHAVIOUR.matcher(lines.get(start)).find()) {
                List<String> fewer = new ArrayList<>(lines);
                int end = start + fewer.subList(start, fewer.size()).indexOf("    }") + 1;
                fewer.subList(start, end).clear();
                add(file, fewer);
            }
        }
    }

    /** A port of that name vanishes from all files, with all that is said about it. */
    private void withoutPort(int file) {
        for (String line : lines(file)) {
            Matcher port = PORT.matcher(line);
            if (port.matches()) {
                String name = port.group(1);
                found.add(files.stream().map(each -> withoutPort(each, name)).toList());
            }
        }
    }

    private static SourceFile withoutPort(SourceFile file, String name) {
        String item = "\\b" + name + " (?:==|=) (?:alt \\{[^}]*\\}|\\[[^\\]]*\\]|[^,}]+)";
        String text =
                file.text()
                        .replaceAll("(?m)^    port .*\\b" + name + ";\n", "")
                        .replaceAll("(?m)^    connect .*\\b" + name + "(?: ->.*)?;\n", "")
                        .replaceAll(" \\[[^\\]{]*\\b" + name + "\\b[^\\]{]*\\]", "")
                        .replaceAll(", " + item, "")
                        .replaceAll(item + "(?:, )?", "");
        return new SourceFile(file.path(), text);
    }

    private void withoutLine(int file) {
        List<String> lines = lines(file);
        for (int i = 1; i < lines.size() - 1; i++) {
            if (lines.get(i).endsWith(";")) {
                List<String> fewer = new ArrayList<>(lines);
                fewer.remove(i);
                add(file, fewer);
            }
        }
    }

    /** What led to a state leads to the first one. */
    private void withoutState(int file) {
        String text = files.get(file).text();
        STATE.matcher(text)
                .results()
                .map(MatchResult::group)
                .distinct()
                .forEach(
                        state -> {
                            String merged =
                                    text.replace("        state " + state + ";\n", "")
                                            .replaceAll("\\b" + state + "\\b", "s0");
                            add(file, merged.lines().toList());
                        });
    }

    private void rewritten(
            int file, Pattern pattern, java.util.function.Function<MatchResult, String> fresh) {
        List<String> lines = lines(file);
        for (int i = 0; i < lines.size(); i++) {
            for (MatchResult match : pattern.matcher(lines.get(i)).results().toList()) {
                List<String> changed = new ArrayList<>(lines);
                changed.set(i, tidy(Edits.replaced(lines.get(i), match, fresh.apply(match))));
                add(file, changed);
            }
        }
    }

    private static String tidy(String line) {
        return line.replace(", }", "}").replace(" / {}", "").replace(" {}", "").replace("{, ", "{");
    }
}
