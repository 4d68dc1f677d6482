package arcomat.benchmarks.frontend;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;

/**
 * Components of 14 states and 40 transitions, and Java classes that do the same, one file each. No
 * two files are equal.
 */
public final class Texts {
    private static final int STATES = 14;
    private static final int TRANSITIONS = 40;

    private Texts() {}

    public static List<SourceFile> models(int count) {
        List<SourceFile> files = new ArrayList<>();
        files.add(
                new SourceFile(
                        "load/Signals.cd",
                        """
                        package load;

                        classdiagram Signals {
                          enum Request { press, release; }
                          enum Light { red, green; }
                        }
                        """));
        for (int i = 0; i < count; i++) {
            files.add(new SourceFile("load/Controller" + i + ".arc", model(i)));
        }
        return files;
    }

    private static String model(int number) {
        StringBuilder text = new StringBuilder();
        text.append("package load;\n\nimport load.Signals.*;\n\n");
        text.append("/** Controller number ").append(number).append(" of the load. */\n");
        text.append("component Controller").append(number).append(" {\n");
        text.append("  port\n    in Request request,\n    in Integer amount,\n");
        text.append("    out Light light,\n    out Integer total;\n\n");
        text.append("  <<completion = \"ignore\">> automaton {\n    state state0");
        for (int s = 1; s < STATES; s++) {
            text.append(", state").append(s);
        }
        text.append(";\n\n    variable Integer level = ").append(number);
        text.append(";\n\n    initial state0 / {light = red};\n\n");
        for (int t = 0; t < TRANSITIONS; t++) {
            text.append("    state").append(t % STATES);
            text.append(" -> state").append(target(number, t));
            text.append(" [level >= ").append(t).append(" && level < ").append(number + 100 + t);
            text.append("] {request == ").append(t % 2 == 0 ? "press" : "release");
            text.append(", amount == ").append(t);
            text.append("} / {light = ").append(t % 3 == 0 ? "red" : "green");
            text.append(", total = amount + ").append(number);
            text.append(", level = level + ").append(t + 1).append("};\n");
        }
        return text.append("  }\n}\n").toString();
    }

    /** The first transition of each state leads to the next one: every state is reached. */
    private static int target(int number, int transition) {
        return (transition < STATES ? transition + 1 : transition * 5 + number) % STATES;
    }

    /** As many classes as make up a length: Java says the same at greater length. */
    static List<SourceFile> classes(long length) {
        List<SourceFile> files = new ArrayList<>();
        long written = 0;
        for (int i = 0; written < length; i++) {
            SourceFile file = new SourceFile("load/Controller" + i + ".java", javaClass(i));
            files.add(file);
            written += file.text().length();
        }
        return files;
    }

    private static String javaClass(int number) {
        StringBuilder text = new StringBuilder();
        text.append("package load;\n\n");
        text.append("/** Controller number ").append(number).append(" of the load. */\n");
        text.append("class Controller").append(number).append(" {\n");
        text.append("  enum Request { PRESS, RELEASE }\n  enum Light { RED, GREEN }\n\n");
        text.append("  Request request;\n  Integer amount;\n  Light light;\n  Integer total;\n");
        text.append("  private int state;\n  private int level = ").append(number).append(";\n\n");
        text.append(
                "  void step() {\n    light = null;\n    total = null;\n    switch (state) {\n");
        for (int s = 0; s < STATES; s++) {
            text.append("      case ").append(s).append(":\n");
            for (int t = s; t < TRANSITIONS; t += STATES) {
                branch(text, number, t);
            }
            text.append("        break;\n");
        }
        return text.append("    }\n  }\n}\n").toString();
    }

    private static void branch(StringBuilder text, int number, int t) {
        text.append("        if (request == Request.").append(t % 2 == 0 ? "PRESS" : "RELEASE");
        text.append(" && amount == ").append(t).append(" && level >= ").append(t);
        text.append(" && level < ").append(number + 100 + t).append(") {\n");
        text.append("          light = Light.").append(t % 3 == 0 ? "RED" : "GREEN").append(";\n");
        text.append("          total = amount + ").append(number).append(";\n");
        text.append("          level = level + ").append(t + 1).append(";\n");
        text.append("          state = ").append(target(number, t)).append(";\n");
        text.append("          return;\n        }\n");
    }

    static long length(List<SourceFile> files) {
        return files.stream().mapToLong(file -> file.text().length()).sum();
    }
}
