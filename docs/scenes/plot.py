"""Plots a column of a table over turns: python3 plot.py TABLE.csv COLUMN > plot.svg"""
import csv
import sys

rows = list(csv.reader(open(sys.argv[1])))
names = [name.split(" [")[0] for name in rows[0]]
points = [(float(row[0]), float(row[names.index(sys.argv[2])])) for row in rows[1:] if row[names.index(sys.argv[2])]]
low, high = min(y for _, y in points), max(y for _, y in points)
path = " ".join(f"{x / points[-1][0] * 600:.2f},{300 - (y - low) / (high - low or 1) * 280:.2f}" for x, y in points)
print(f'<svg xmlns="http://www.w3.org/2000/svg" width="640" height="340" viewBox="-20 -20 640 340">'
      f'<polyline points="{path}" fill="none" stroke="#2b84ad"/><text y="-5">{rows[0][names.index(sys.argv[2])]}: '
      f'{low:g} to {high:g} in {points[-1][0]:g} turns</text></svg>')
