package arcomat.gradle;

import arcomat.plugin.ToolCommand;

import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.Optional;
import org.gradle.api.tasks.UntrackedTask;
import org.gradle.api.tasks.options.Option;

/** Runs a component and prints what happened, slice by slice. */
@UntrackedTask(because = "Its result is what it prints.")
public abstract class SimulateArc extends ModelTask {
    @Input
    @Optional
    @Option(option = "main", description = "The component to run, such as p.Robot or 'p.Timer(2)'.")
    public abstract Property<String> getMain();

    @Input
    @Optional
    @Option(option = "slices", description = "How many slices.")
    public abstract Property<String> getSlices();

    @Input
    @Optional
    @Option(option = "seed", description = "Seed of whatever is drawn.")
    public abstract Property<String> getSeed();

    @Input
    @Optional
    @Option(option = "choose", description = "Who decides what is left open: first, random.")
    public abstract Property<String> getChoose();

    @Input
    @Optional
    @Option(option = "input", description = "A stream test to take the input of: FILE.mt#test.")
    public abstract Property<String> getStreams();

    @Input
    @Optional
    @Option(option = "trace", description = "How to write what happened: table, csv, json.")
    public abstract Property<String> getTrace();

    @Override
    final ToolCommand command() {
        return ToolCommand.of("simulate")
                .with("--main", said(getMain()))
                .with("--slices", said(getSlices()))
                .with("--seed", said(getSeed()))
                .with("--choose", said(getChoose()))
                .with("--input", said(getStreams()))
                .with("--trace", said(getTrace()));
    }

    @Override
    final void conclude(ToolResult result) {
        result.require(getLogger());
        getLogger().quiet(result.out().stripTrailing());
    }
}
