"""A parallel projection: what of a body in space is seen, and where on a picture."""

import numpy as np


class Camera:
    """Looks at the origin along a direction; y is up on the picture."""

    def __init__(self, azimuth, elevation):
        """Degrees: the azimuth from the front (+z) towards the right (+x), the elevation up."""
        a, e = np.radians(azimuth), np.radians(elevation)
        self.towards = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
        self.right = np.array([np.cos(a), 0.0, -np.sin(a)])
        self.up = np.cross(self.towards, self.right)

    def project(self, points):
        """(..., 3) to (..., 2): to the right and up."""
        return points @ np.stack([self.right, self.up], axis=1)

    def depth(self, points):
        """Larger is nearer to the viewer."""
        return points @ self.towards


def visible_faces(cells, camera):
    """The faces of unit cubes that a viewer may see: those turned to it that no other cube covers.

    `cells` are whole numbers, (n, 3). Gives, the farthest first, the cube that each face belongs
    to, its corners in units of a cube, and the axis that it is normal to.
    """
    taken = keys(cells)
    owners, corners, axes = [], [], []
    for axis in range(3):
        step = np.zeros(3, int)
        step[axis] = 1 if camera.towards[axis] > 0 else -1
        bare = np.flatnonzero(~np.isin(keys(cells + step), taken))
        one, two = np.eye(3)[(axis + 1) % 3] / 2, np.eye(3)[(axis + 2) % 3] / 2
        around = np.array([-one - two, one - two, one + two, two - one])
        owners.append(bare)
        corners.append((cells[bare] + 0.5 * step)[:, None, :] + around)
        axes.append(np.full(len(bare), axis))
    owners, corners, axes = map(np.concatenate, (owners, corners, axes))
    # By the depth of whole cubes: a face's own would put it before a cube that covers it.
    order = np.argsort(camera.depth(cells[owners]), kind="stable")
    return owners[order], corners[order], axes[order]


def keys(cells):
    """One number for each cell."""
    places = cells + (1 << 20)
    return (places[:, 0] << 42) + (places[:, 1] << 21) + places[:, 2]
