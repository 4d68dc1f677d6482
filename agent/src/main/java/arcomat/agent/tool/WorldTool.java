package arcomat.agent.tool;

import arcomat.pipeline.WrongUse;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.report.finding.FindingsJson;
import arcomat.report.world.WorldRunJson;
import arcomat.sim.device.Limits;
import arcomat.sim.time.OutOfPatience;
import arcomat.world.Recording;
import arcomat.world.Seeds;

import java.util.ArrayList;
import java.util.List;

/** Robots on a floor. */
final class WorldTool implements Tool {
    private static final String WORLD = "world";
    private static final String SEED = "seed";
    private static final String SET = "set";
    private static final String REFUSED = "The world cannot run; these are the findings about it.";

    @Override
    public String name() {
        return "world";
    }

    @Override
    public String description() {
        return "Runs the robots of a world (.world), each with its program on a simulated brick,"
                + " and tells what happened when, and how it ended: collisions, cups, programs"
                + " that failed.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.text(WORLD, "The file of the world.").asRequired(),
                ToolParameter.number(SEED, Long.MIN_VALUE, Long.MAX_VALUE, "Of noise; default 1."),
                ToolParameter.values(SET, "Values of parameters of the world, by their names."));
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        ToolArguments told = call.arguments();
        String file = told.required(WORLD);
        // Devices that a world names in Java would run with the rights of who started the tool.
        PreparedWorld prepared =
                call.session().run(new PrepareWorld(file, false, told.values(SET)));
        List<String> remarks = new ArrayList<>(ToolAnswer.remarks(prepared.aside()));
        if (!prepared.canRun()) {
            remarks.add(0, REFUSED);
            return new ToolAnswer(
                    FindingsJson.render(prepared.findings(), prepared.files()), remarks);
        }
        long seed = told.number(SEED, Long.MIN_VALUE, Long.MAX_VALUE).orElse(1L);
        Recording recording = run(prepared, seed, call);
        return new ToolAnswer(WorldRunJson.render(file, recording, prepared.findings()), remarks);
    }

    private static Recording run(PreparedWorld world, long seed, ToolCall call) throws WrongUse {
        try {
            return world.run(Seeds.of(seed), call.patience(), Limits.OF_THE_BRICK);
        } catch (OutOfPatience e) {
            throw new WrongUse("unknown: given up: " + e.getMessage());
        }
    }
}
