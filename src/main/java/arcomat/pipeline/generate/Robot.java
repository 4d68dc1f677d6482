package arcomat.pipeline.generate;

import arcomat.brick.BrickReport;

/**
 * A program for the brick.
 *
 * @param component qualified name of the component that it runs
 * @param jar path of the jar below the output folder
 * @param report what is known about the jar before it is linked
 */
public record Robot(String component, String jar, BrickReport report) {}
