/** Pictures of measurements: colours for light and for dark pages, text that is wrapped, files. */
package steward.lab.chart;
