package arcomat.live.pack;

import org.teavm.diagnostics.DefaultProblemTextConsumer;
import org.teavm.diagnostics.Problem;
import org.teavm.model.CallLocation;
import org.teavm.tooling.EmptyTeaVMToolLog;
import org.teavm.tooling.TeaVMTargetType;
import org.teavm.tooling.TeaVMTool;
import org.teavm.vm.TeaVMOptimizationLevel;

import java.io.File;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.util.List;
import java.util.stream.Stream;

/**
 * Compiles the core to one module of WebAssembly. What a browser does not have is a problem, with
 * the method that asks for it: it has to stay out of what the live page can reach.
 */
public final class CoreCompiler {
    private static final String BEGINNING = "arcomat.live.browser.Door";

    private CoreCompiler() {}

    /**
     * @param args the class path, and the file to write; {@code quick} compiles sooner what is
     *     slower, larger and has names that a profiler can show
     */
    public static void main(String[] args) throws Exception {
        File result = new File(args[1]);
        TeaVMTool tool = new TeaVMTool();
        tool.setClassLoader(new URLClassLoader(urls(args[0]), CoreCompiler.class.getClassLoader()));
        tool.setMainClass(BEGINNING);
        tool.setTargetType(TeaVMTargetType.WEBASSEMBLY_GC);
        tool.setTargetDirectory(result.getParentFile());
        tool.setTargetFileName(result.getName());
        boolean quick = args.length > 2 && args[2].equals("quick");
        tool.setOptimizationLevel(
                quick ? TeaVMOptimizationLevel.SIMPLE : TeaVMOptimizationLevel.ADVANCED);
        tool.setObfuscated(!quick);
        tool.setAssertionsRemoved(true); // as where Java runs without -ea
        // A wrong index, null or a wrong cast ends the question by itself, as a trap; with checks
        // of its own, a quarter more, it would be an exception, which nobody in the core catches.
        tool.setStrict(false);
        tool.setIncremental(false);
        tool.getTransformers().add(NeedlessTexts.class.getName());
        tool.getTransformers().add(NeverMade.class.getName());
        tool.getTransformers().add(EmptyMaps.class.getName());
        tool.getTransformers().add(JavaDivisions.class.getName());
        tool.setLog(new EmptyTeaVMToolLog());
        tool.generate();
        List<String> problems =
                tool.getProblemProvider().getSevereProblems().stream()
                        .map(CoreCompiler::words)
                        .toList();
        if (!problems.isEmpty()) {
            problems.forEach(System.err::println);
            throw new IllegalStateException("the core does not compile for the browser");
        }
    }

    private static URL[] urls(String path) throws MalformedURLException {
        List<File> files = Stream.of(path.split(File.pathSeparator)).map(File::new).toList();
        URL[] urls = new URL[files.size()];
        for (int i = 0; i < urls.length; i++) {
            urls[i] = files.get(i).toURI().toURL();
        }
        return urls;
    }

    private static String words(Problem problem) {
        DefaultProblemTextConsumer text = new DefaultProblemTextConsumer();
        problem.render(text);
        CallLocation place = problem.getLocation();
        String where = place == null ? "" : ", asked for by " + place.getMethod();
        return text.getText() + where;
    }
}
