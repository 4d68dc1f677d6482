package arcomat.laws.draw;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Changes one line of a component, so that the old and the new one have something to do. */
public final class Edits {
    private static final Pattern TRANSITION = Pattern.compile("s\\d+ -> s\\d+");
    private static final Pattern CLAUSE = Pattern.compile(TRANSITION + "|=>");
    private static final Pattern CONSTANT =
            Pattern.compile("\\b(?:true|false|k|l|m)\\b|(?<= )[012]\\b");
    private static final Pattern COMPLETION = Pattern.compile("(?<=completion = \")\\w+");
    static final Pattern GUARD = Pattern.compile(" \\[(?:[^\\[\\]])*\\](?= |;)");
    static final Pattern ITEM = Pattern.compile("(?:\\w+ == (?:alt \\{[^}]*\\}|[^,}]+))");

    private final Draw draw;

    public Edits(Draw draw) {
        this.draw = draw;
    }

    /** One of the files is changed a little. */
    public List<SourceFile> once(List<SourceFile> files) {
        List<SourceFile> changed = new ArrayList<>(files);
        int position = draw.below(files.size());
        SourceFile file = files.get(position);
        List<String> lines = new ArrayList<>(file.text().lines().toList());
        edit(lines);
        changed.set(position, new SourceFile(file.path(), String.join("\n", lines) + "\n"));
        return changed;
    }

    /** An atomic component with one more input and output, which other sides know nothing of. */
    public SourceFile withMorePorts(SourceFile file) {
        List<String> lines = new ArrayList<>(file.text().lines().toList());
        boolean events = file.text().contains("timing untimed");
        for (int i = 0; i < lines.size(); i++) {
            boolean transition = TRANSITION.matcher(lines.get(i)).find();
            if (transition && draw.chance(40)) {
                lines.set(i, withMore(lines.get(i), events));
            }
        }
        int head = events ? 3 : 2;
        String delay = events || draw.chance(50) ? "" : "<<delay = \"0\">> ";
        lines.add(head, "    port in Boolean e;");
        lines.add(head + 1, "    port " + delay + "out Boolean f;");
        return new SourceFile(file.path(), String.join("\n", lines) + "\n");
    }

    private String withMore(String line, boolean events) {
        String[] sides = line.split("(?= /|;)", 2);
        String asked = sides[0];
        if (events) {
            asked = asked.replaceAll(" \\[.*\\]| \\{.*\\}", "") + " {e == true}";
            return asked + ";";
        }
        asked =
                asked.endsWith("}")
                        ? asked.substring(0, asked.length() - 1) + ", e == true}"
                        : asked + " {e == true}";
        return asked + sides[1].replace(" / {", " / {f = true, ");
    }

    private void edit(List<String> lines) {
        int kind = draw.below(10);
        if (kind < 3) {
            without(lines);
        } else if (kind < 5) {
            beside(lines);
        } else if (kind == 5 && draw.has(Features.OPEN)) {
            replace(lines, COMPLETION, draw.one("chaos", "output", "ignore"));
        } else if (kind == 6) {
            replace(lines, GUARD, "");
        } else if (kind == 7) {
            replace(lines, Pattern.compile("(?<= -> s)\\d+"), String.valueOf(draw.below(3)));
        } else if (kind == 8 && draw.has(Features.MIXED_DELAYS)) {
            replace(lines, Pattern.compile("port out"), "port <<delay = \"0\">> out");
        } else {
            constant(lines);
        }
    }

    private List<Integer> lines(List<String> lines, Pattern pattern) {
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            if (pattern.matcher(lines.get(i)).find()) {
                found.add(i);
            }
        }
        return found;
    }

    private void without(List<String> lines) {
        List<Integer> clauses = lines(lines, CLAUSE);
        if (!clauses.isEmpty()) {
            lines.remove((int) draw.one(clauses));
        }
    }

    /** A further transition or row, much like one that is there. */
    private void beside(List<String> lines) {
        List<Integer> clauses = lines(lines, CLAUSE);
        if (!clauses.isEmpty()) {
            int position = draw.one(clauses);
            lines.add(position, lines.get(position));
            List<String> copy = new ArrayList<>(List.of(lines.get(position)));
            constant(copy);
            lines.set(position, copy.get(0));
        }
    }

    private void constant(List<String> lines) {
        List<Integer> possible =
                lines(lines, CONSTANT).stream()
                        .filter(i -> lines.get(i).matches("\\s+(?:s\\d|initial|\\|).*"))
                        .toList();
        if (!possible.isEmpty()) {
            int position = draw.one(possible);
            String line = lines.get(position);
            MatchResult found = draw.one(CONSTANT.matcher(line).results().toList());
            lines.set(position, replaced(line, found, another(found.group())));
        }
    }

    private String another(String constant) {
        return switch (constant) {
            case "true" -> "false";
            case "false" -> "true";
            case "k", "l", "m" -> draw.one("k", "l", "m");
            default -> draw.one("0", "1", "2");
        };
    }

    private void replace(List<String> lines, Pattern pattern, String fresh) {
        List<Integer> possible = lines(lines, pattern);
        if (!possible.isEmpty()) {
            int position = draw.one(possible);
            String line = lines.get(position);
            MatchResult found = draw.one(pattern.matcher(line).results().toList());
            lines.set(position, replaced(line, found, fresh));
        }
    }

    static String replaced(String line, MatchResult found, String fresh) {
        return line.substring(0, found.start()) + fresh + line.substring(found.end());
    }
}
