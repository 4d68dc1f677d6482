package arcomat.docs;

import java.util.ArrayList;
import java.util.List;

/** What a block of a page shows of a terminal: commands, each with what it prints. */
record Session(List<Step> steps) {
    private static final String PROMPT = "$ ";

    /**
     * @param output the lines that the page shows
     */
    record Step(String command, List<String> output) {
        /** Without empty lines at its ends, as what is printed is compared. */
        String text() {
            return Terminal.withoutEmptyEnds(String.join("\n", output)) + "\n";
        }
    }

    static Session of(Fence fence) {
        List<Step> steps = new ArrayList<>();
        for (String line : fence.body()) {
            if (line.startsWith(PROMPT)) {
                steps.add(new Step(line.substring(PROMPT.length()), new ArrayList<>()));
            } else if (steps.isEmpty()) {
                throw new AssertionError("line " + fence.line() + ": no command before " + line);
            } else {
                steps.get(steps.size() - 1).output().add(line);
            }
        }
        return new Session(steps);
    }

    List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (Step step : steps) {
            lines.add(PROMPT + step.command());
            lines.addAll(step.output());
        }
        return lines;
    }
}
