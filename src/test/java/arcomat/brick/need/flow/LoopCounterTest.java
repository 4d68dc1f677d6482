package arcomat.brick.need.flow;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickCompiler;
import arcomat.graph.StrongComponents;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.IntStream;

/** Loops that are counted, and those of which nothing can be said. */
class LoopCounterTest {
    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "for (int i = 0; i < 10; i++) work();                          # 10",
                "for (int i = 0; i <= 10; i++) work();                         # 11",
                "for (int i = 0; i < 10; i += 3) work();                       # 4",
                "for (int i = 10; i > 0; i--) work();                          # 10",
                "for (int i = 10; i >= 0; i--) work();                         # 11",
                "for (int i = 300; i > 40000; i--) work();                     # 0",
                "for (int i = 0; i < 100000; i++) work();                      # 100000",
                "for (int i = 0; !(i >= 10); i++) work();                      # 10",
                "int i = 0; do { work(); i++; } while (i < 10);                # 10",
                "for (int i = 0; i < 10 && work(); i++) work();                # 10",
                "for (int i = 0; i < 10; i++) if (work()) break;               # 10",
                "for (int i = 0; i < 10; i++) { if (work()) continue; work(); }# 10",
                "for (int k = 7; k < 9;) k++; for (int i = 5; i < 10; i++) work(); # 2 5",
                "for (int i = 0; i < 10; i++) for (int k = 0; k < n; k++) work();  # 10 none",
                "int i = work() ? 2 : 4; while (i < 10) i++;                   # none",
                "int i; if (work()) i = 2; else i = 4; while (i < 10) i++;     # 8",
                "for (int i = 0; i < n; i++) work();                           # none",
                "for (int i = n; i < 10; i++) work();                          # none",
                "for (int i = 0; i < 10 || work(); i++) work();                # none",
                "for (int i = 0; i != 10; i++) work();                         # none",
                "for (int i = 0; i < 10; i--) work();                          # none",
                "for (int i = 0; i < 10; i += n) work();                       # none",
                "for (int i = 0; i < 10; i++) if (work()) i = 0;               # none",
                "for (int i = 0; i < 10; i++) if (work()) i--;                 # none",
                "for (int i = 0; i < 10;) if (work()) i++;                     # none",
                "int i = 0; while (work()) i++;                                # none",
                "int i = 0; while (i < 10) for (int k = 0; k < n; k++) i++;    # none none",
                "int i = 0; while (work()) { if (work() && i < 10) work(); i++; }  # none",
                "while (true) work();                                          # none",
                "for (int i = 0; i < 10; i++) for (int k = 3; k < 9; k++) work();  # 10 6",
                "for (int i = 0; i < 10; i++) for (int k = i; k < 9; k++) work();  # 10 none",
                "while (work()) { while (n < 10) n++; n = 0; }                 # none none",
                "int k = 5; while (work()) { while (k < 10) k++; k = 2; }      # none 8",
            })
    void loopsFromTheStartAndFromOutsideIn(String loop, String expected) {
        MethodNode method = method(loop);
        FlowGraph graph = new FlowGraph(method);
        BitSet all = new BitSet();
        all.set(0, graph.size());
        List<String> rounds = new ArrayList<>();
        addLoops(graph, all, rounds);
        assertThat(String.join(" ", rounds)).isEqualTo(expected);
    }

    private static void addLoops(FlowGraph graph, BitSet among, List<String> rounds) {
        List<int[]> loops = StrongComponents.of(graph.among(among)).cyclic();
        for (int i = loops.size() - 1; i >= 0; i--) {
            BitSet knot = new BitSet();
            IntStream.of(loops.get(i)).forEach(knot::set);
            if (knot.cardinality() > 1) {
                int head = head(graph, knot);
                OptionalLong known = new LoopCounter(graph, knot, head).rounds();
                rounds.add(known.isPresent() ? "" + known.getAsLong() : "none");
                knot.clear(head);
                addLoops(graph, knot, rounds);
            }
        }
    }

    private static int head(FlowGraph graph, BitSet knot) {
        List<Integer> heads = knot.stream().filter(i -> isEntered(graph, i, knot)).boxed().toList();
        assertThat(heads).hasSize(1);
        return heads.get(0);
    }

    private static boolean isEntered(FlowGraph graph, int position, BitSet knot) {
        return position == 0 || graph.before(position).stream().anyMatch(each -> !knot.get(each));
    }

    private static MethodNode method(String loop) {
        SourceFile source =
                new SourceFile(
                        "Robot.java",
                        "abstract class Robot { abstract boolean work(); void run(int n) { "
                                + loop
                                + " } }");
        ClassNode node = new ClassNode();
        new ClassReader(compiler.forBrick(source).orFail().get("Robot")).accept(node, 0);
        return node.methods.stream().filter(m -> m.name.equals("run")).findFirst().orElseThrow();
    }
}
