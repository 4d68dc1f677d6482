package arcomat.benchmarks.network;

import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** The network as a model, and the loop that drives what is generated from it. */
final class NetworkText {
    private static final String STAGE =
            """
            package load;

            component Stage {
              port
                in Integer input,
                out Integer output;

              <<completion = "ignore">> automaton {
                state even, odd;

                initial even;

                even -> odd {input == ?} / {output = input + 1};
                odd -> even {input == ?} / {output = input};
              }
            }
            """;

    private NetworkText() {}

    /**
     * @param shuffled whether parts and connectors are declared in no order
     */
    static List<SourceFile> models(Shape shape, boolean shuffled) {
        return List.of(
                new SourceFile("load/Stage.arc", STAGE),
                new SourceFile("load/Net.arc", net(shape, shuffled)));
    }

    private static String net(Shape shape, boolean shuffled) {
        List<String> parts = new ArrayList<>();
        List<String> connectors = new ArrayList<>();
        StringBuilder ports = new StringBuilder("  port in Integer input");
        for (int chain = 0; chain < shape.chains(); chain++) {
            ports.append(", out Integer output").append(chain);
            String sender = "input";
            for (int i = 0; i < shape.length(); i++) {
                String part = "part" + chain + "x" + i;
                parts.add("  component Stage " + part + ";\n");
                connectors.add("  connect " + sender + " -> " + part + ".input;\n");
                sender = part + ".output";
            }
            connectors.add("  connect " + sender + " -> output" + chain + ";\n");
        }
        if (shuffled) {
            Collections.shuffle(parts, new Random(1));
            Collections.shuffle(connectors, new Random(2));
        }
        return "package load;\n\ncomponent Net {\n"
                + ports
                + ";\n"
                + String.join("", parts)
                + String.join("", connectors)
                + "}\n";
    }

    /** What a user writes around generated code. */
    static SourceFile driver(Shape shape) {
        StringBuilder text =
                new StringBuilder(
                        """
                        package load.logic;

                        public final class Driver implements arcomat.benchmarks.network.Network {
                            private final Net net = new Net();

                            public int run(int[] messages) {
                                int sum = 0;
                                for (int message : messages) {
                                    net.input = message;
                                    net.hasInput = message != 0;
                                    net.step();
                                    int sent = 0;
                        """);
        for (int chain = 0; chain < shape.chains(); chain++) {
            text.append("            sent += net.hasOutput").append(chain);
            text.append(" ? net.output").append(chain).append(" : 0;\n");
        }
        text.append(
                "            sum = sum * 31 + sent;\n        }\n        return sum;\n    }\n}\n");
        return new SourceFile("load/logic/Driver.java", text.toString());
    }
}
