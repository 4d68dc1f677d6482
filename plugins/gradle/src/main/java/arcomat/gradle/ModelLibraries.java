package arcomat.gradle;

import arcomat.plugin.ModelFiles;

import org.gradle.api.Project;
import org.gradle.api.artifacts.Configuration;
import org.gradle.api.artifacts.ConfigurationContainer;
import org.gradle.api.attributes.AttributeCompatibilityRule;
import org.gradle.api.attributes.CompatibilityCheckDetails;
import org.gradle.api.attributes.Usage;
import org.gradle.api.component.AdhocComponentWithVariants;
import org.gradle.api.plugins.JavaPlugin;
import org.gradle.api.tasks.TaskProvider;
import org.gradle.api.tasks.bundling.Jar;

/**
 * Models as artifacts: those of other projects, which models may refer to and whose code is in the
 * jars of those projects, and the jar by which others refer to the models of this one.
 */
final class ModelLibraries {
    private static final String USED = "arcomatModels";
    private static final String USAGE = "arcomat-models";

    private final Project project;
    private final ConfigurationContainer configurations;

    ModelLibraries(Project project) {
        this.project = project;
        this.configurations = project.getConfigurations();
    }

    /** Gives a project both. */
    void register(ModelSources main) {
        Configuration used = used();
        TaskProvider<UnpackModels> unpacked = unpack(path(used));
        project.getTasks()
                .withType(ModelTask.class)
                .configureEach(
                        task -> {
                            if (isAboutMeaning(task)) {
                                task.getLibraries()
                                        .convention(unpacked.flatMap(UnpackModels::getOutput));
                            }
                        });
        offer(elements(used), modelsJar(main));
    }

    /** How a text is laid out depends on nobody else. */
    private static boolean isAboutMeaning(ModelTask task) {
        return !(task instanceof FormatArc || task instanceof CheckArcFormat);
    }

    /** What is said in {@code dependencies}: one line gives models and, by a jar, their code. */
    private Configuration used() {
        Configuration used = bucket(USED, "Projects whose models are referred to.");
        used.setCanBeResolved(false);
        used.setCanBeConsumed(false);
        configurations
                .named(JavaPlugin.IMPLEMENTATION_CONFIGURATION_NAME)
                .configure(code -> code.extendsFrom(used));
        // Code of models names that of the models that they refer to.
        configurations
                .named(JavaPlugin.API_ELEMENTS_CONFIGURATION_NAME)
                .configure(code -> code.extendsFrom(used));
        return used;
    }

    private Configuration path(Configuration used) {
        project.getDependencies()
                .getAttributesSchema()
                .attribute(Usage.USAGE_ATTRIBUTE)
                .getCompatibilityRules()
                .add(WhateverRuns.class);
        Configuration path = bucket("arcomatModelPath", "The models that are referred to.");
        path.extendsFrom(used);
        path.setCanBeConsumed(false);
        mark(path);
        return path;
    }

    private Configuration elements(Configuration used) {
        Configuration elements = bucket("arcomatModelElements", "The models, for other projects.");
        elements.extendsFrom(used);
        elements.setCanBeResolved(false);
        mark(elements);
        return elements;
    }

    private Configuration bucket(String name, String description) {
        Configuration bucket = configurations.create(name);
        bucket.setDescription(description);
        bucket.setVisible(false);
        return bucket;
    }

    private void mark(Configuration configuration) {
        Usage models = project.getObjects().named(Usage.class, USAGE);
        configuration.getAttributes().attribute(Usage.USAGE_ATTRIBUTE, models);
    }

    /**
     * A module of another build tool does not say that it has models: its jar, named with a
     * classifier, is what there is.
     */
    public static final class WhateverRuns implements AttributeCompatibilityRule<Usage> {
        /** Called by Gradle. */
        public WhateverRuns() {}

        @Override
        public void execute(CompatibilityCheckDetails<Usage> details) {
            Usage wanted = details.getConsumerValue();
            Usage there = details.getProducerValue();
            if (wanted != null
                    && there != null
                    && wanted.getName().equals(USAGE)
                    && there.getName().equals(Usage.JAVA_RUNTIME)) {
                details.compatible();
            }
        }
    }

    private TaskProvider<UnpackModels> unpack(Configuration path) {
        return project.getTasks()
                .register(
                        "unpackArcModels",
                        UnpackModels.class,
                        task -> {
                            task.setGroup(ArcomatPlugin.NAME);
                            task.setDescription("Unpacks the models of other projects.");
                            task.getArchives().from(path);
                            task.getOutput()
                                    .convention(
                                            project.getLayout()
                                                    .getBuildDirectory()
                                                    .dir("arcomat/libraries"));
                        });
    }

    private TaskProvider<Jar> modelsJar(ModelSources main) {
        return project.getTasks()
                .register(
                        "modelsJar",
                        Jar.class,
                        task -> {
                            task.setGroup(ArcomatPlugin.NAME);
                            task.setDescription(
                                    "Packs the models, for projects that refer to them.");
                            task.getArchiveClassifier().set(ModelFiles.CLASSIFIER);
                            task.setPreserveFileTimestamps(false);
                            task.setReproducibleFileOrder(true);
                            task.from(main.forOthers());
                        });
    }

    /** For other projects of the build, and among what is published. */
    private void offer(Configuration elements, TaskProvider<Jar> jar) {
        elements.getOutgoing().artifact(jar);
        project.getComponents()
                .named("java", AdhocComponentWithVariants.class)
                .configure(
                        java ->
                                java.addVariantsFromConfiguration(
                                        elements, variant -> variant.mapToMavenScope("compile")));
    }
}
